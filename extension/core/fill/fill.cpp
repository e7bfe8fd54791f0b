// SPDX-License-Identifier: MIT
#include "core/fill/fill.h"

#include "core/paint/hand_paint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

constexpr const MapChannelInfo &DENSITY = info_of(MAP_DENSITY);
constexpr size_t BATCH = 128; // chunks that are computed before they are written: 2 MiB

// A texel in a neighbouring chunk that has no part of the area.
struct RimTexel {
	int i, j;
	int32_t code;
};

struct FilledChunk {
	std::shared_ptr<const MapTexels> texels; // null: nothing but the base density
	std::vector<RimTexel> rim;
	double amount = 0.0;
	int64_t cells = 0;
	bool has_changed = false;
};

// Computes one chunk. Only reads the map.
class ChunkFill {
public:
	ChunkFill(const PaintMap &p_map, const MapKey &p_key, const MapRegion &p_area, FillRim p_rim, const FillRule *p_rule,
			const FillSources &p_sources) :
			_map(p_map),
			_key(p_key),
			_area(p_area),
			_filled(p_rim == FillRim::FILLED ? p_area.grown(DENSITY.texel_size()) : p_area),
			_rule(p_rule),
			_sources(p_sources),
			_ground(p_map, MAP_GROUND),
			_normal(p_map, MAP_NORMAL),
			_density(p_map, MAP_DENSITY),
			_paint(p_map, MAP_PAINT) {
		if (_rule == nullptr) {
			return;
		}
		const Eigen::Array2d low(p_key.x * MAP_CHUNK_SIZE, p_key.z * MAP_CHUNK_SIZE), high = low + MAP_CHUNK_SIZE;
		for (const std::shared_ptr<const FillObstacle> &obstacle : p_sources.obstacles) {
			if (obstacle->reaches(low, high)) {
				(obstacle->is_planting() ? _planted : _obstacles).push_back(obstacle.get());
			}
		}
		for (const std::shared_ptr<const FillObstacle> &obstacle : p_sources.gone) {
			if (obstacle->reaches(low, high)) {
				_gone.push_back(obstacle.get());
			}
		}
		if (p_sources.has_mesh) {
			_mesh_shares =
					p_sources.mesh ? p_sources.mesh->get_shares(p_key) : std::vector<double>(size_t(DENSITY.side) * size_t(DENSITY.side));
		}
		_asks_ground = _rule->asks_height() || !_obstacles.empty();
	}

	FilledChunk run() {
		FilledChunk filled;
		auto texels = std::make_shared<MapTexels>(DENSITY.chunk_bytes());
		const int32_t base = _map.initial_code(MAP_DENSITY, 0);
		bool is_plain = true;
		for (int row = 0; row < DENSITY.side; row++) {
			for (int column = 0; column < DENSITY.side; column++) {
				const int i = _key.x * DENSITY.side + column, j = _key.z * DENSITY.side + row;
				const size_t texel = size_t(row) * size_t(DENSITY.side) + size_t(column);
				const bool counts = is_in(_area, centre_of(i, j));
				const int32_t before = _density.code(0, i, j), after = is_in(_filled, centre_of(i, j)) ? filled_code(i, j, texel) : before;
				(*texels)[texel] = uint8_t(after);
				filled.cells += counts ? 1 : 0;
				filled.amount += counts ? double(after - before) : 0.0;
				filled.has_changed = filled.has_changed || after != before;
				is_plain = is_plain && after == base;
			}
		}
		fill_rim(filled);
		filled.amount *= DENSITY.unit * DENSITY.texel_size() * DENSITY.texel_size();
		filled.texels = is_plain ? nullptr : std::move(texels);
		return filled;
	}

private:
	static Eigen::Vector2d centre_of(int p_i, int p_j) { return Eigen::Vector2d(p_i + 0.5, p_j + 0.5) * DENSITY.texel_size(); }
	// Returns whether a texel is in an area. One on the far border belongs to the next area.
	static bool is_in(const MapRegion &p_area, const Eigen::Vector2d &p_at) {
		return (p_at.array() >= p_area.min.array()).all() && (p_at.array() < p_area.max.array()).all();
	}

	// Returns the code that the rule gives a texel. p_texel: index in the chunk of this texel, or of the nearest one.
	int32_t filled_code(int p_i, int p_j, size_t p_texel) {
		const Eigen::Vector2d centre = centre_of(p_i, p_j);
		if (_rule != nullptr && _rule->only_at_obstacles && !is_at_obstacle(centre)) {
			return _density.code(0, p_i, p_j);
		}
		const int32_t filling =
				_rule == nullptr ? _map.initial_code(MAP_DENSITY, 0) : DENSITY.code(std::max(ask(centre, p_texel), plant(centre)));
		return HandPaint{ _paint.code(0, p_i, p_j), _paint.code(1, p_i, p_j) }.over(filling);
	}

	bool is_at_obstacle(const Eigen::Vector2d &p_at) const {
		const auto changes = [&p_at](const FillObstacle *p_obstacle) { return p_obstacle->may_change(p_at); };
		return std::ranges::any_of(_obstacles, changes) || std::ranges::any_of(_planted, changes) || std::ranges::any_of(_gone, changes);
	}

	// Fills the texels around the chunk. Where the area ends at the chunk's border, the texels that blend into it are in the next chunk,
	// which is not filled itself.
	void fill_rim(FilledChunk &r_filled) {
		for (int row = -1; row <= DENSITY.side; row++) {
			for (int column = -1; column <= DENSITY.side; column++) {
				const int inside_row = std::clamp(row, 0, DENSITY.side - 1), inside_column = std::clamp(column, 0, DENSITY.side - 1);
				if (row == inside_row && column == inside_column) {
					column = DENSITY.side - 1; // skip to the other end of the row
					continue;
				}
				const int i = _key.x * DENSITY.side + column, j = _key.z * DENSITY.side + row;
				if (!is_in(_filled, centre_of(i, j)) || is_in(_area, centre_of(i, j))) {
					continue;
				}
				const int32_t before = _density.code(0, i, j);
				const int32_t after = filled_code(i, j, size_t(inside_row) * size_t(DENSITY.side) + size_t(inside_column));
				if (after != before) {
					r_filled.rim.push_back({ i, j, after });
				}
			}
		}
	}

	// Returns the density that the rule gives a place. Tests cheap conditions first, and stops when a condition leaves nothing.
	double ask(const Eigen::Vector2d &p_at, size_t p_texel) {
		double share = _rule->get(FILL_DENSITY) * _rule->mask_share(p_at);
		share *= _mesh_shares.empty() ? 1.0 : _mesh_shares[p_texel];
		share *= share > 0.0 ? _sources.texture_share(*_rule, p_at) : 1.0;
		if (share > 0.0 && _rule->asks_slope()) {
			const double tilt = std::min(1.0, std::hypot(_normal.sample(0, p_at), _normal.sample(1, p_at))); // sine of the slope
			share *= _rule->slope_share(std::asin(tilt) * 180.0 / std::numbers::pi);
		}
		const FillPlace place{ p_at, share > 0.0 && _asks_ground ? _ground.sample(0, p_at) : 0.0 };
		share *= _rule->asks_height() ? _rule->height_share(place.ground) : 1.0;
		for (size_t i = 0; i < _obstacles.size() && share > 0.0; i++) {
			share *= _obstacles[i]->get_share(place);
		}
		return share > 0.0 ? share * _rule->noise_share(p_at) : 0.0;
	}

	// Returns the density from obstacles that plant; only obstacles reduce it.
	double plant(const Eigen::Vector2d &p_at) {
		double share = 0.0;
		for (const FillObstacle *planted : _planted) {
			share = std::max(share, 1.0 - planted->get_share({ p_at, 0.0 }));
		}
		const FillPlace place{ p_at, share > 0.0 && _asks_ground ? _ground.sample(0, p_at) : 0.0 };
		for (size_t i = 0; i < _obstacles.size() && share > 0.0; i++) {
			share *= _obstacles[i]->get_share(place);
		}
		return share;
	}

	const PaintMap &_map;
	MapKey _key;
	const MapRegion &_area;
	MapRegion _filled; // _area with its rim
	const FillRule *_rule;
	const FillSources &_sources;
	MapReader _ground, _normal, _density, _paint;
	std::vector<const FillObstacle *> _obstacles, _planted, _gone;
	std::vector<double> _mesh_shares; // empty: the rule has no mesh
	bool _asks_ground = false;
};

} // namespace

std::vector<MapKey> chunks_in(const MapRegion &p_area) {
	std::vector<MapKey> keys;
	if (p_area.min.hasNaN() || p_area.max.hasNaN()) {
		return keys;
	}
	constexpr double REACH = PaintMap::REACH;
	const Eigen::Array2i first = (p_area.min.array() / MAP_CHUNK_SIZE).floor().max(-REACH).min(REACH).cast<int>(),
						 end = (p_area.max.array() / MAP_CHUNK_SIZE).ceil().max(-REACH).min(REACH).cast<int>();
	for (int x = first.x(); x < end.x(); x++) {
		for (int z = first.y(); z < end.y(); z++) {
			keys.push_back({ x, z });
		}
	}
	return keys;
}

FillResult fill(PaintMap &r_map, std::span<const MapKey> p_keys, const MapRegion &p_area, const FillRule *p_rule,
		const FillSources &p_sources, const ParallelFor &p_parallel_for, FillRim p_rim) {
	FillResult result;
	for (size_t first = 0; first < p_keys.size(); first += BATCH) {
		const std::span<const MapKey> keys = p_keys.subspan(first, std::min(BATCH, p_keys.size() - first));
		std::vector<FilledChunk> filled(keys.size());
		p_parallel_for(int(keys.size()), [&](int p_index) {
			filled[size_t(p_index)] = ChunkFill(r_map, keys[size_t(p_index)], p_area, p_rim, p_rule, p_sources).run();
		});
		for (size_t n = 0; n < keys.size(); n++) { // filling a chunk does not depend on other chunks
			result.cells += filled[n].cells;
			for (const RimTexel &texel : filled[n].rim) {
				result.out_of_room = !r_map.set_code(MAP_DENSITY, 0, texel.i, texel.j, texel.code) || result.out_of_room;
			}
			if (!filled[n].has_changed && filled[n].rim.empty()) {
				continue;
			}
			if (!r_map.set_texels(keys[n], MAP_DENSITY, std::move(filled[n].texels))) {
				result.out_of_room = true;
				continue;
			}
			const MapRegion here = MapRegion::of_chunk(keys[n]).shared(p_area);
			const MapRegion all = result.changed.empty() ? here : here.joined({ result.min, result.max });
			result.min = all.min;
			result.max = all.max;
			result.changed.push_back(keys[n]);
			result.amount += filled[n].amount;
		}
	}
	return result;
}

} // namespace grass
