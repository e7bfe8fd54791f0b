// SPDX-License-Identifier: MIT
#include "core/species/species.h"

#include "core/map/map_layers.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace grass {

namespace {

// How far the borders of stands fray at most, as a share of a stand's size.
constexpr double FRAYS = 0.25;

constexpr double LIMIT = 256.0 * 65536.0; // one more than the greatest sum in grass_species_takes()

// Returns the quantiles of stand noise, ascending. They do not depend on where the lattice is.
const std::vector<uint32_t> &noise_values() {
	static const std::vector<uint32_t> values = [] {
		constexpr uint32_t CELL = 8, SIDE = 64 * CELL; // 4096 cells, 64 places in each
		std::vector<uint32_t> counts(65536); // for each value
		for (uint32_t z = 0; z < SIDE; z++) {
			for (uint32_t x = 0; x < SIDE; x++) {
				counts[grass_stand_noise(x, z, CELL, 1, 0, 0)]++;
			}
		}
		std::vector<uint32_t> found;
		found.reserve(SIDE * SIDE);
		for (uint32_t value = 0; value < uint32_t(counts.size()); value++) {
			found.insert(found.end(), counts[value], value);
		}
		return found;
	}();
	return values;
}

// Returns p_a / p_b, rounded down.
int64_t floor_of(int64_t p_a, int64_t p_b) {
	return p_a / p_b - (p_a % p_b < 0 ? 1 : 0);
}

// Returns the share of the blades whose number is below p_limit where the noise is p_noise.
double share_below(double p_limit, double p_noise, double p_strength) {
	const double left = p_limit - p_noise * p_strength, span = (256.0 - p_strength) * 65536.0;
	return span > 0.0 ? std::clamp(left / span, 0.0, 1.0) : (left > 0.0 ? 1.0 : 0.0);
}

// [Eq P2] Returns the limit below which the numbers of a share of all blades are.
int32_t search_limit(double p_share, int32_t p_strength) {
	if (p_share <= 0.0) {
		return 0;
	}
	if (p_share >= 1.0) {
		return int32_t(LIMIT);
	}
	const std::vector<uint32_t> &noise = noise_values();
	if (p_strength == 0) {
		return int32_t(std::lround(p_share * LIMIT));
	}
	constexpr size_t STRIDE = 16; // the values ascend, so every sixteenth represents them
	const size_t count = noise.size() / STRIDE;
	int32_t low = 0, high = int32_t(LIMIT);
	while (high - low > 16) {
		const int32_t middle = low + (high - low) / 2;
		double share = 0.0;
		for (size_t i = 0; i < noise.size(); i += STRIDE) {
			share += share_below(middle, noise[i], p_strength);
		}
		(share / double(count) < p_share ? low : high) = middle;
	}
	return high;
}

// Returns search_limit(), cached: every plot of a world makes the same mix, and a search takes a tenth of a millisecond.
int32_t find_limit(double p_share, int32_t p_strength) {
	constexpr size_t MOST = 256;
	static std::mutex mutex;
	static std::map<std::pair<double, int32_t>, int32_t> known; // guarded by mutex
	std::lock_guard lock(mutex);
	if (known.size() > MOST) {
		known.clear();
	}
	const auto [entry, is_new] = known.try_emplace({ p_share, p_strength }, 0);
	if (is_new) {
		entry->second = search_limit(p_share, p_strength);
	}
	return entry->second;
}

} // namespace

SpeciesMix::SpeciesMix(std::span<const SpeciesParams> p_species, const TileGrid &p_grid, uint32_t p_seed, const Eigen::Vector2d &p_origin) :
		_grid(p_grid), _seed(p_seed), _count(int(std::min<size_t>(p_species.size(), GRASS_MAX_SPECIES))) {
	const double units = GRASS_ROOT_UNITS / p_grid.get_tile_size(); // units in a metre
	_texel_units = int(std::lround(units * GRASS_CHUNK_SIZE / GRASS_COARSE_TEXELS));
	const int64_t x = std::llround(p_origin.x() * units), z = std::llround(p_origin.y() * units);
	double total = 0.0; // of the species so far: later ones choose first
	for (int s = 0; s < _count; s++) {
		const SpeciesParams &params = p_species[size_t(s)];
		const double share = SPECIES_SHARE.clamp(params.share);
		total += share;
		SpeciesRecord &record = _records[size_t(s)];
		record.cell = std::max(int32_t(std::lround(STAND_SIZE.clamp(params.stand_size) * units)), 1);
		record.strength = int32_t(std::lround(STAND_STRENGTH.clamp(params.stand_strength) * 256.0));
		record.limit = find_limit(total > 0.0 ? share / total : 0.0, record.strength);
		record.stems = std::clamp(params.stems, 1, int(PLANT_STEMS.maximum));
		const double edge = STAND_EDGE.clamp(params.stand_edge);
		record.fray = int32_t(std::lround(edge * FRAYS * record.cell));
		record.falls = params.falls ? float(edge) : 0.0f;
		record.column = int32_t(floor_of(x, record.cell));
		record.row = int32_t(floor_of(z, record.cell));
		record.x = int32_t(x - int64_t(record.column) * record.cell);
		record.z = int32_t(z - int64_t(record.row) * record.cell);
		record.salt = int32_t(grass_hash(p_seed + 0x5eed0000u + uint32_t(s)) >> 1);
		_shares[size_t(s)] = share;
	}
	for (int s = 0; s < _count; s++) {
		_shares[size_t(s)] = total > 0.0 ? _shares[size_t(s)] / total : (s == 0 ? 1.0 : 0.0);
	}
}

// Returns the painted species, or -1.
int SpeciesMix::find_painted(int p_texel_x, int p_texel_z, const MapLayers *p_layers) const {
	const int painted = p_layers ? p_layers->get_species(p_texel_x, p_texel_z) - 1 : -1;
	return painted < _count ? painted : -1;
}

// What choose_species() needs to know of a blade, or of a plant with several.
struct SpeciesMix::Place {
	int x, z; // units
	uint32_t bits, blade; // bits of the tile; the blade whose random numbers decide
};

// Returns [Eq P1] of the place where a blade is looked up, [Eq P6].
uint32_t SpeciesMix::noise_at(const SpeciesRecord &p_record, const Place &p_place, int p_species) {
	if (p_record.strength == 0) {
		return 0;
	}
	const auto moved = [&](int p_units, uint32_t p_axis) {
		return grass_stand_place(uint32_t(p_units), uint32_t(p_record.fray), p_place.bits, p_place.blade, uint32_t(p_species), p_axis);
	};
	return grass_stand_noise(moved(p_place.x + p_record.x, 0), moved(p_place.z + p_record.z, 1), uint32_t(p_record.cell),
			uint32_t(p_record.salt), uint32_t(p_record.column), uint32_t(p_record.row));
}

int SpeciesMix::find_painted(const Place &p_place, const MapLayers *p_layers) const {
	if (!p_layers) {
		return -1;
	}
	const float size = float(_grid.get_tile_size());
	const uint32_t first = grass_species_random(p_place.bits, p_place.blade, GRASS_MAX_SPECIES),
				   second = grass_species_random(p_place.bits, p_place.blade, GRASS_MAX_SPECIES + 1);
	return find_painted(grass_species_texel(p_place.x, first, _texel_units, float(_grid.get_tiles_x()), size),
			grass_species_texel(p_place.z, second, _texel_units, float(_grid.get_tiles_z()), size), p_layers);
}

// The twin of choose_species() in shaders/species/choice.inc.
int SpeciesMix::choose_species(
		int p_tile_x, int p_tile_z, int p_blade, const RootOf &p_root_of, const MapLayers *p_layers, float *r_height) const {
	const uint32_t tile_seed = uint32_t(grass_tile_hash(uint32_t(p_tile_x), uint32_t(p_tile_z), _seed) * 2048.0f);
	const uint32_t bits = grass_tile_bits(uint32_t(p_tile_x), uint32_t(p_tile_z), tile_seed);
	const int start = int(grass_tile_start(uint32_t(p_tile_x), uint32_t(p_tile_z), _seed));
	const auto place_of = [&](int p_of, int p_in_patch) {
		const Eigen::Vector2f root = p_root_of(p_in_patch);
		return Place{ grass_root_units(p_tile_x, root.x()), grass_root_units(p_tile_z, root.y()), bits, uint32_t(p_of) };
	};
	const auto plant_of = [&](int p_stems) { // the plant that the blade is a stem of
		const int first = p_blade - p_blade % p_stems;
		return place_of(first, (start + first) / p_stems);
	};
	const Place own = place_of(p_blade, start + p_blade);
	float apart = 1.0f; // from the borders of stands
	const auto found = [&](int p_species) {
		if (r_height != nullptr) {
			*r_height = 1.0f - _records[size_t(p_species)].falls * (1.0f - apart);
		}
		return p_species;
	};
	for (int s = 0; s < _count && p_layers != nullptr; s++) { // paint covers a whole plant or none of it, by its root
		const int stems = _records[size_t(s)].stems;
		if (stems > 1 && find_painted(plant_of(stems), p_layers) == s) {
			return found(s);
		}
	}
	if (const int painted = find_painted(own, p_layers); painted >= 0 && _records[size_t(painted)].stems == 1) {
		return found(painted);
	}
	for (int s = _count - 1; s > 0; s--) {
		const SpeciesRecord &record = _records[size_t(s)];
		const Place at = record.stems > 1 ? plant_of(record.stems) : own; // the stems of a plant are chosen together
		if (record.stems > 1 && find_painted(at, p_layers) >= 0) {
			continue;
		}
		const uint32_t strength = uint32_t(record.strength), limit = uint32_t(record.limit), noise = noise_at(record, at, s);
		const bool takes = grass_species_takes(noise, strength, limit, grass_species_random(bits, at.blade, uint32_t(s)));
		apart = std::min(apart, grass_stand_apart(noise, strength, limit, takes));
		if (takes) {
			return found(s);
		}
	}
	return found(0);
}

int SpeciesMix::choose_species(int p_tile_x, int p_tile_z, int p_blade, const Eigen::Vector2f &p_root, const MapLayers *p_layers) const {
	return choose_species(
			p_tile_x, p_tile_z, p_blade, [&p_root](int) { return p_root; }, p_layers);
}

std::array<float, GRASS_MAX_SPECIES> SpeciesMix::get_shares_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const {
	std::array<float, GRASS_MAX_SPECIES> shares{};
	const Eigen::Array2d in_tiles = p_place.cast<double>().array() / _grid.get_tile_size() +
			0.5 * Eigen::Array2d(double(_grid.get_tiles_x()), double(_grid.get_tiles_z()));
	const Eigen::Array2d most = Eigen::Array2d(double(_grid.get_tiles_x()), double(_grid.get_tiles_z()));
	const Eigen::Array2d units = in_tiles.max(0.0).min(most) * double(GRASS_ROOT_UNITS);
	const double per_metre = GRASS_COARSE_TEXELS / GRASS_CHUNK_SIZE;
	const Eigen::Array2d texel = (p_place.cast<double>().array() * per_metre).floor();
	if (const int painted = find_painted(int(texel.x()), int(texel.y()), p_layers); painted >= 0) {
		shares[size_t(painted)] = 1.0f;
		return shares;
	}
	float left = 1.0f;
	for (int s = _count - 1; s > 0; s--) {
		const SpeciesRecord &record = _records[size_t(s)];
		const float taken = left *
				grass_species_chance(uint32_t(units.x()) + uint32_t(record.x), uint32_t(units.y()) + uint32_t(record.z),
						uint32_t(record.fray), uint32_t(record.cell), uint32_t(record.strength), uint32_t(record.limit),
						uint32_t(record.salt), uint32_t(record.column), uint32_t(record.row));
		shares[size_t(s)] = taken;
		left -= taken;
	}
	shares[0] = left;
	return shares;
}

double near_plants(double p_distance, double p_density, int64_t p_vertices) {
	const double a_metre = p_density * double(p_vertices) * std::numbers::pi; // vertices within a metre
	return a_metre * p_distance * p_distance > NEAR_PLANT_VERTICES ? std::sqrt(NEAR_PLANT_VERTICES / a_metre) : p_distance;
}

} // namespace grass
