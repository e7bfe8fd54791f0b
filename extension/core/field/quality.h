// SPDX-License-Identifier: MIT
// What a game's options menu scales in all of its fields. A field multiplies its own numbers by these factors where it uses them, so what
// a scene stores stays as it was designed.
#pragma once

#include "core/base/tunable.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace grass {

enum class QualityLevel {
	LOW,
	MEDIUM,
	HIGH, // as it was designed
	ULTRA,
	CUSTOM, // the game sets each factor
};

enum QualityFactorId {
	QUALITY_PIXELS_MIN,
	QUALITY_LOD_ERROR,
	QUALITY_LOD_FAR,
	QUALITY_SHADOW_DISTANCE,
	QUALITY_SHADOW_COARSENESS,
	QUALITY_PLANT_DISTANCE,
	QUALITY_CONTACT_RATE,
	QUALITY_POOL_TILES,
	QUALITY_FACTORS,
};

inline constexpr size_t QUALITY_LEVELS = size_t(QualityLevel::CUSTOM); // that have factors of their own

struct QualityFactor {
	QualityFactorId id;
	Tunable tunable; // named after the property that it multiplies
	std::array<double, QUALITY_LEVELS> of_levels;
};

// LOW goes as far as the defaults allow before the picture looks coarse: see the comments beside the numbers that are multiplied. A plant's
// distance never grows, since there is only room for the plants within it.
inline constexpr std::array QUALITY_TABLE = {
	QualityFactor{ QUALITY_PIXELS_MIN, { "pixels_min", "x", 0.1, 4.0, 0.05, 1.0 }, { 1.6, 1.3, 1.0, 0.75 } },
	QualityFactor{ QUALITY_LOD_ERROR, { "lod_error", "x", 0.1, 8.0, 0.05, 1.0 }, { 2.0, 1.5, 1.0, 0.7 } },
	QualityFactor{ QUALITY_LOD_FAR, { "lod_far", "x", 0.1, 4.0, 0.05, 1.0 }, { 0.4, 0.7, 1.0, 1.5 } },
	QualityFactor{ QUALITY_SHADOW_DISTANCE, { "shadow_distance", "x", 0.0, 4.0, 0.05, 1.0 }, { 0.25, 0.6, 1.0, 1.5 } },
	QualityFactor{ QUALITY_SHADOW_COARSENESS, { "shadow_coarseness", "x", 0.1, 4.0, 0.05, 1.0 }, { 2.0, 1.5, 1.0, 0.75 } },
	QualityFactor{ QUALITY_PLANT_DISTANCE, { "plant_distance", "x", 0.1, 1.0, 0.05, 1.0 }, { 0.5, 0.75, 1.0, 1.0 } },
	QualityFactor{ QUALITY_CONTACT_RATE, { "contact_rate", "x", 0.5, 16.0, 0.5, 1.0 }, { 0.5, 0.5, 1.0, 2.0 } },
	QualityFactor{ QUALITY_POOL_TILES, { "pool_tiles", "x", 0.0, 4.0, 0.05, 1.0 }, { 0.25, 0.5, 1.0, 2.0 } },
};

struct Quality {
	std::array<double, QUALITY_FACTORS> factors = of_level(QualityLevel::HIGH);

	double factor(QualityFactorId p_id) const { return factors[size_t(p_id)]; }
	// Returns the factors of a level. CUSTOM: as HIGH, from which a game may begin.
	static constexpr std::array<double, QUALITY_FACTORS> of_level(QualityLevel p_level) {
		const size_t level = size_t(p_level == QualityLevel::CUSTOM ? QualityLevel::HIGH : p_level);
		std::array<double, QUALITY_FACTORS> factors{};
		for (const QualityFactor &factor : QUALITY_TABLE) {
			factors[size_t(factor.id)] = factor.of_levels[level];
		}
		return factors;
	}
	// Returns a field's number, scaled, within the number's own limits.
	double scale(QualityFactorId p_id, const Tunable &p_tunable, double p_value) const { return p_tunable.clamp(p_value * factor(p_id)); }
	// Returns the tiles of a pool, scaled: at least one, unless there is none or the factor is 0.
	int64_t scale_pool(int64_t p_tiles) const;
	bool operator==(const Quality &) const = default;
};

// Returns whether a table of p_count entries can be indexed by their ids.
template <typename Table> consteval bool is_indexed_by_id(const Table &p_table, size_t p_count) {
	for (size_t i = 0; i < p_table.size(); i++) {
		if (size_t(p_table[i].id) != i) {
			return false;
		}
	}
	return p_table.size() == p_count;
}
static_assert(is_indexed_by_id(QUALITY_TABLE, QUALITY_FACTORS));

} // namespace grass
