// SPDX-License-Identifier: MIT
// A tile of blades by their strains, for tests: they stand at rest, and have the parameters, as those of a BladeScene.
#pragma once

#include "blade_scene.h"

#include "core/strain/basis.h"
#include "core/strain/strain_tile.h"

namespace grass::test {

struct StrainScene {
	BladeScene blades;
	std::unique_ptr<StrainState> state = std::make_unique<StrainState>();
	StrainTileStep step_function = step_strains;
	float energy = 0.0f; // [Eq Q10] of the liveliest blade as the last step began, J/kg

	explicit StrainScene(BladeScene p_blades = BladeScene()) : blades(std::move(p_blades)) { find_lengths(*blades.tile, *state); }
	// Of half a metre, all as the way from root to tip that p_way leads, a direction by the share of the way.
	static StrainScene along(const std::function<Eigen::Vector3d(double)> &p_way) {
		BladeScene blades;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			Eigen::Vector3d knot = Eigen::Vector3d::Zero();
			for (int k = 0; k < GRASS_KNOTS; k++) {
				blades.set_rest(b, k, knot.cast<float>());
				knot += p_way((k + 0.5) / GRASS_SEGMENTS) * (0.5 / GRASS_SEGMENTS);
			}
			blades.tile->width[0][b] = 0.0f;
			blades.tile->width[1][b] = 1.0f;
		}
		return StrainScene(std::move(blades));
	}
	static StrainScene straight() {
		return along([](double) { return Eigen::Vector3d::UnitY(); });
	}

	SolverParams &params() { return blades.params; }
	void step(double p_seconds = 1.0 / 60.0) {
		if (_taper != blades.params.taper || _wide != blades.params.width_to_thickness) {
			_taper = blades.params.taper;
			_wide = blades.params.width_to_thickness;
			_section = make_strain_section(_taper, _wide);
		}
		const StrainSpecies species{ blades.clock.advance(blades.params, p_seconds), _section };
		energy = step_function(*blades.tile, *state, { &species, 1 }, blades.blend);
	}
	void step_for(double p_seconds, double p_rate = 60.0) {
		for (int i = 0; i < int(std::lround(p_seconds * p_rate)); i++) {
			step(1.0 / p_rate);
		}
	}
	// Standing where a load of density area g length^3 / EI, for an even blade, holds them along p_way, and let go without a jump.
	void hold(double p_gamma, const Eigen::Vector3d &p_way) {
		const double damping = blades.params.damping_ratio, share = 6.2831853 * blades.params.natural_frequency / 3.5160152685;
		blades.params.damping_ratio = 1.2;
		for (int i = 0; i < 600; i++) {
			for (int c = 0; c < 3; c++) {
				blades.params.load[c] = p_way.normalized()[c] * p_gamma * share * share * 0.5 * std::min(1.0, (i + 1) / 200.0);
			}
			step();
		}
		std::memcpy(state->before, state->strains, sizeof(state->before));
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
				for (int c = 0; c < 3; c++) {
					state->masses_before[c][i][b] = offset(b, GRASS_STRAIN_FIRST_MASS + 2 * i)[c];
				}
			}
		}
		blades.params.damping_ratio = damping;
		for (double &load : blades.params.load) {
			load = 0.0;
		}
		blades.clock.reset();
	}

	Eigen::Vector3f offset(int p_blade, int p_knot) const {
		const int free = p_knot - GRASS_CLAMPED_KNOTS;
		const auto &offsets = state->offsets;
		return free < 0 ? Eigen::Vector3f::Zero()
						: Eigen::Vector3f(offsets[0][free][p_blade], offsets[1][free][p_blade], offsets[2][free][p_blade]);
	}
	Eigen::Vector3f knot(int p_blade, int p_knot) const { return blades.rest(p_blade, p_knot) + offset(p_blade, p_knot); }
	// The largest of them, whatever it is of; NaN if one is.
	float largest_number() const {
		float most = 0.0f;
		for (const auto &row : state->strains) {
			for (const float number : row) {
				most = std::abs(number) <= most || std::isnan(most) ? most : std::abs(number);
			}
		}
		return most;
	}

private:
	double _taper = -1.0, _wide = -1.0;
	StrainSection<float> _section;
};

} // namespace grass::test
