// SPDX-License-Identifier: MIT
#include "core/blades/patch.h"

#include "core/base/functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/half.h"
#include "core/base/hash.h"
#include "core/blades/roots.h"
#include "core/blades/tussock.h"

namespace grass {

namespace {

constexpr double TURN = 2.0 * std::numbers::pi;

// The segments of a shorter blade would be too short for the simulation to distinguish from zero.
constexpr double SHORTEST = 0.01; // metres

// The golden ratio spreads the azimuths of any run of blades evenly.
constexpr double GOLDEN = 0.6180339887498949;

// How much a blade's bend and its direction of lean may differ from those of its type.
constexpr double BEND_MIN = 0.7;
constexpr double BEND_MAX = 1.2;
constexpr double SWAY = 0.4; // radians

// The random properties of a blade, one hash channel each. Other numbers would change the blades of every scene.
enum Channel : uint32_t { AZIMUTH = 2, TYPE, LENGTH, LENGTH_MORE, WIDTH, BEND, TWIST, SWAY_ANGLE };

// The random numbers of one blade, each from 0 up to but not including 1.
class Dice {
public:
	Dice(uint32_t p_seed, uint32_t p_blade) : _base(grass_hash(p_seed ^ grass_hash(p_blade))) {}
	double roll(Channel p_channel) const { return grass_hash(_base + p_channel) / 4294967296.0; }

private:
	uint32_t _base;
};

double fraction(double p_value) {
	return p_value - std::floor(p_value);
}

double between(double p_least, double p_most, double p_share) {
	return p_least + (p_most - p_least) * p_share;
}

PatchParams cleaned(const PatchParams &p_params) {
	PatchParams params = p_params;
	params.length_min = LENGTH_MIN.clamp(params.length_min);
	params.length_max = std::max(params.length_min, LENGTH_MAX.clamp(params.length_max));
	params.width_min = WIDTH_MIN.clamp(params.width_min);
	params.width_max = std::max(params.width_min, WIDTH_MAX.clamp(params.width_max));
	for (size_t type = 0; type < params.weights.size(); ++type) {
		params.weights[type] = TYPE_WEIGHTS[type].clamp(params.weights[type]);
	}
	return params;
}

double total_weight(const PatchParams &p_params) {
	double total = 0.0;
	for (const double weight : p_params.weights) {
		total += weight;
	}
	return total;
}

const BladeType &pick_type(const PatchParams &p_params, double p_share) {
	double left = p_share * total_weight(p_params);
	size_t last = 0;
	for (size_t type = 0; type < BLADE_TYPES.size(); ++type) {
		if (p_params.weights[type] <= 0.0) {
			continue;
		}
		last = type;
		left -= p_params.weights[type];
		if (left < 0.0) {
			break;
		}
	}
	return BLADE_TYPES[last];
}

void store(Patch &r_patch, int p_blade, int p_knot, double p_x, double p_y, double p_z, double p_w) {
	uint16_t *texel = &r_patch.texels[Patch::texel_index(p_blade, p_knot)];
	texel[0] = float_to_half(float(p_x));
	texel[1] = float_to_half(float(p_y));
	texel[2] = float_to_half(float(p_z));
	texel[3] = float_to_half(float(p_w));
}

// Derives lengths and heights from the stored halves, since those are the rest shape.
void measure(Patch &r_patch, int p_blade) {
	Eigen::Vector3f before = Eigen::Vector3f::Zero();
	float length = 0.0f;
	float height = 0.0f;
	for (int k = 1; k < GRASS_KNOTS; ++k) {
		const uint16_t *texel = &r_patch.texels[Patch::texel_index(p_blade, k)];
		const Eigen::Vector3f knot(half_to_float(texel[0]), half_to_float(texel[1]), half_to_float(texel[2]));
		length += (knot - before).norm();
		before = knot;
		r_patch.max_spread = std::max(r_patch.max_spread, std::hypot(knot.x(), knot.z()));
		height = std::max(height, knot.y());
	}
	r_patch.max_height = std::max(r_patch.max_height, height);
	r_patch.mean_height += height / GRASS_PATCH_BLADES;
	r_patch.max_length = std::max(r_patch.max_length, length);
	r_patch.mean_length += length / GRASS_PATCH_BLADES;
	r_patch.mean_width += half_to_float(r_patch.texels[Patch::texel_index(p_blade, 0) + 3]) / GRASS_PATCH_BLADES;
}

void plant(Patch &r_patch, const PatchParams &p_params, const Eigen::Vector2d &p_root, int p_blade) {
	const Dice dice(p_params.seed, uint32_t(p_blade));
	const double azimuth = TURN * (fraction(GOLDEN * p_blade + 0.25 * dice.roll(AZIMUTH)) - 0.5);

	// The mean of two random numbers makes middle lengths commoner than extreme ones; long blades tend to be wide.
	const double tall = 0.5 * (dice.roll(LENGTH) + dice.roll(LENGTH_MORE));
	const double length = std::max(SHORTEST, between(p_params.length_min, p_params.length_max, tall));
	const double width = between(p_params.width_min, p_params.width_max, 0.5 * (tall + dice.roll(WIDTH)));

	const BladeType &type = pick_type(p_params, dice.roll(TYPE));
	const double twist_side = dice.roll(TWIST) * 2.0 - 1.0;
	const BladeCurve curve = blade_curve(type, between(BEND_MIN, BEND_MAX, dice.roll(BEND)), twist_side);

	// A blade leans roughly across its width.
	const double lean = azimuth + 0.25 * TURN + SWAY * (dice.roll(SWAY_ANGLE) * 2.0 - 1.0);
	const double along_x = cosine(lean);
	const double along_z = sine(lean);
	store(r_patch, p_blade, 0, p_root.x(), p_root.y(), azimuth, width);
	for (int k = 1; k < GRASS_KNOTS; ++k) {
		const Eigen::Vector3d knot = curve.knots[k] * length;
		store(r_patch, p_blade, k, knot.x() * along_x - knot.z() * along_z, knot.y(), knot.x() * along_z + knot.z() * along_x,
				curve.twist[k]);
	}
	measure(r_patch, p_blade);
}

// Turns a blade to its place around the root that p_stems blades share. The first of them keeps its azimuth.
void spread_stem(Patch &r_patch, int p_blade, int p_stems) {
	const int stem = p_blade % p_stems;
	uint16_t *root = &r_patch.texels[Patch::texel_index(p_blade, 0)];
	const double first = half_to_float(r_patch.texels[Patch::texel_index(p_blade - stem, 0) + 2]), before = half_to_float(root[2]);
	const double azimuth = TURN * (fraction(first / TURN + 0.5 + double(stem) / p_stems) - 0.5), angle = azimuth - before;
	const double along_x = cosine(angle), along_z = sine(angle);
	root[2] = float_to_half(float(azimuth));
	for (int k = 1; k < GRASS_KNOTS; ++k) {
		uint16_t *texel = &r_patch.texels[Patch::texel_index(p_blade, k)];
		const double x = half_to_float(texel[0]), z = half_to_float(texel[2]);
		texel[0] = float_to_half(float(x * along_x - z * along_z));
		texel[2] = float_to_half(float(z * along_x + x * along_z));
	}
}

} // namespace

PatchParams::PatchParams() {
	for (size_t type = 0; type < weights.size(); ++type) {
		weights[type] = TYPE_WEIGHTS[type].initial;
	}
}

Patch generate_patch(const PatchParams &p_params, const std::atomic<bool> *p_stop) {
	const PatchParams params = cleaned(p_params);
	Patch patch;
	patch.texels.assign(size_t(Patch::WIDTH) * Patch::HEIGHT * 4, 0);
	if (params.length_max <= 0.0) {
		patch.empty_because = "the longest blade has a length of zero";
	} else if (total_weight(params) <= 0.0) {
		patch.empty_because = "every blade type has a weight of zero";
	} else {
		const std::vector<Eigen::Vector2d> roots = scatter_roots(params.seed, GRASS_PATCH_BLADES);
		for (int blade = 0; blade < GRASS_PATCH_BLADES && !(p_stop != nullptr && *p_stop); ++blade) {
			plant(patch, params, roots[size_t(blade)], blade);
		}
	}
	return patch;
}

void measure_patch(Patch &r_patch) {
	r_patch.max_length = r_patch.max_spread = r_patch.max_height = 0.0f;
	r_patch.mean_height = r_patch.mean_length = r_patch.mean_width = 0.0f;
	for (int blade = 0; blade < GRASS_PATCH_BLADES; ++blade) {
		measure(r_patch, blade);
	}
}

Patch join_patches(std::span<const std::shared_ptr<const Patch>> p_patches, std::span<const double> p_shares, std::span<const int> p_stems,
		std::span<const Tussocks> p_tussocks) {
	const auto found = std::find_if(p_patches.begin(), p_patches.end(), [](const auto &p_patch) { return !p_patch->is_empty(); });
	if (found == p_patches.end()) {
		Patch empty = generate_patch({});
		empty.texels.assign(empty.texels.size() * p_patches.size(), 0);
		empty.species = int(p_patches.size());
		empty.empty_because = p_patches.empty() ? "there is no species" : p_patches.front()->empty_because;
		return empty;
	}
	const Patch &first = **found;
	Patch joined;
	joined.species = int(p_patches.size());
	joined.texels.reserve(p_patches.size() * first.texels.size());
	const auto has_tussocks = [&](size_t p_species) { return p_species < p_tussocks.size() && p_tussocks[p_species].share > 0.0; };
	for (size_t s = 0; s < p_patches.size(); s++) {
		const Patch &own = p_patches[s]->is_empty() ? first : *p_patches[s];
		joined.texels.insert(joined.texels.end(), own.texels.begin(), own.texels.end());
		const int stems = s < p_stems.size() ? p_stems[s] : 1;
		for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
			uint16_t *root = &joined.texels[Patch::texel_index(int(s) * GRASS_PATCH_BLADES + blade, 0)];
			// Where the roots of a tile decide about its plants, there they grow.
			const Patch &places = stems > 1 && s > 0 && has_tussocks(0) ? joined : first;
			// Take neighbouring plants: every nth would grow in rows.
			const uint16_t *place = &places.texels[Patch::texel_index(blade / stems, 0)];
			root[0] = place[0];
			root[1] = place[1];
			root[3] = p_patches[s]->is_empty() ? 0 : root[3];
			if (stems > 1) {
				spread_stem(joined, int(s) * GRASS_PATCH_BLADES + blade, stems);
			}
		}
		if (stems == 1 && has_tussocks(s)) {
			gather_roots(joined, int(s) * GRASS_PATCH_BLADES, first, p_tussocks[s]);
		}
		const float share = float(p_shares[s]);
		joined.max_length = std::max(joined.max_length, own.max_length);
		joined.max_spread = std::max(joined.max_spread, own.max_spread);
		joined.max_height = std::max(joined.max_height, own.max_height);
		joined.mean_height += share * own.mean_height;
		joined.mean_length += share * own.mean_length;
		joined.mean_width += share * own.mean_width;
	}
	return joined;
}

} // namespace grass
