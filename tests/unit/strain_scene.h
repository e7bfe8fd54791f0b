// SPDX-License-Identifier: MIT
// A tile of blades by their strains, for tests: they stand at rest, and have the parameters, as those of a BladeScene.
#pragma once

#include "blade_scene.h"

#include "core/solver/strain/basis.h"
#include "core/solver/strain/strain.h"

namespace grass::test {

struct StrainScene {
	BladeScene blades;

	explicit StrainScene(BladeScene p_blades = BladeScene()) : blades(std::move(p_blades)) { blades.tile->has_strains = true; }
	// Of half a metre, all as the way from root to tip that p_way leads, a direction by the share of the way.
	static StrainScene along(const std::function<Eigen::Vector3d(double)> &p_way) {
		BladeScene blades;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			Eigen::Vector3d knot = Eigen::Vector3d::Zero();
			for (int k = 0; k < GRASS_KNOTS; k++) {
				blades.set_rest(b, k, knot.cast<float>());
				knot += p_way(knot_share(k) + 0.5 * segment_share(k)) * (0.5 * segment_share(k));
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
		blades.tile->sections = &_section;
		blades.step(p_seconds);
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
		TileState &tile = *blades.tile;
		std::memcpy(tile.strains_before, tile.strains, sizeof(tile.strains));
		std::memcpy(tile.before, tile.knots, sizeof(tile.knots));
		blades.params.damping_ratio = damping;
		for (double &load : blades.params.load) {
			load = 0.0;
		}
		blades.clock.reset();
	}

	Eigen::Vector3f offset(int p_blade, int p_knot) const { return knot(p_blade, p_knot) - blades.rest(p_blade, p_knot); }
	Eigen::Vector3f knot(int p_blade, int p_knot) const { return blades.knot(p_blade, p_knot); }
	// Returns the largest of them, whatever it is of; NaN if one is.
	float largest_number() const {
		float most = 0.0f;
		for (const auto &row : blades.tile->strains) {
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
