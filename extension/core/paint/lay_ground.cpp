// SPDX-License-Identifier: MIT
#include "core/paint/lay_ground.h"

#include "core/paint/changed_texels.h"

#include <cmath>

namespace grass {

namespace {

static_assert(GROUND_TEXEL == info_of(MAP_NORMAL).texel_size() && GROUND_TEXEL == info_of(MAP_HOLE).texel_size());

// Writes a texel's channels and records what changed.
class GroundWriter {
public:
	GroundWriter(PaintMap &r_map, LaidGround &r_result) :
			_map(r_map), _result(r_result), _changed(MAP_GROUND), _moved(LedgeCell::moved_spots(r_map.get_ground_grid())) {}

	void lay(int p_i, int p_j, double p_height, const Eigen::Vector3d &p_normal) {
		bool differs = write(MAP_GROUND, 0, p_i, p_j, info_of(MAP_GROUND).code(p_height));
		differs = write(MAP_NORMAL, 0, p_i, p_j, info_of(MAP_NORMAL).code(p_normal.x())) || differs;
		differs = write(MAP_NORMAL, 1, p_i, p_j, info_of(MAP_NORMAL).code(p_normal.z())) || differs;
		differs = write(MAP_HOLE, 0, p_i, p_j, 0) || differs;
		note(differs, p_i, p_j);
	}
	// Opens a hole. p_rim: height of the ground beside it. Without it, blades at the rim would drop to 0.
	void open(int p_i, int p_j, double p_rim) {
		bool differs = std::isfinite(p_rim) && write(MAP_GROUND, 0, p_i, p_j, info_of(MAP_GROUND).code(p_rim));
		differs = write(MAP_HOLE, 0, p_i, p_j, 1) || differs;
		note(differs, p_i, p_j);
	}
	// Lays a ledge. p_codes: of the spots of the cell whose first texel is p_i, p_j. Null: the cell has no ledge.
	void lay_ledge(int p_i, int p_j, const uint8_t *p_codes) {
		const Eigen::Array2i first = LedgeCell::first_spot(p_i, p_j) + _moved;
		bool differs = false;
		for (int n = 0; n < LedgeCell::SPOTS * LedgeCell::SPOTS; n++) {
			const int32_t code = p_codes != nullptr ? p_codes[n] : GRASS_LEDGE_NONE;
			differs = write(MAP_LEDGE, 0, first.x() + n % LedgeCell::SPOTS, first.y() + n / LedgeCell::SPOTS, code) || differs;
		}
		note(differs, p_i, p_j);
		note(differs, p_i + 1, p_j + 1);
	}
	void report() { _changed.report(_result); }

private:
	bool write(MapChannel p_channel, int p_component, int p_i, int p_j, int32_t p_code) {
		if (_map.get_code(p_channel, p_component, p_i, p_j) == p_code) {
			return false;
		}
		const bool written = _map.set_code(p_channel, p_component, p_i, p_j, p_code);
		_result.out_of_room = _result.out_of_room || !written;
		return written;
	}
	void note(bool p_differs, int p_i, int p_j) {
		if (p_differs) {
			_changed.add(p_i, p_j);
		}
	}

	PaintMap &_map;
	LaidGround &_result;
	ChangedTexels _changed;
	Eigen::Array2i _moved;
};

// Lays the ground of a block of texels.
class GroundLayer {
public:
	GroundLayer(PaintMap &r_map, const GroundReading &p_ground, const NormalAt &p_normal, LaidGround &r_result) :
			_map(r_map), _ground(p_ground), _normal(p_normal), _result(r_result), _writer(r_map, r_result) {}

	void run() {
		for (int j = _ground.get_first().y(); j <= _ground.get_last().y(); j++) {
			for (int i = _ground.get_first().x(); i <= _ground.get_last().x(); i++) {
				lay_texel(i, j);
			}
		}
		for (const auto &[i, j] : find_gone()) {
			_writer.lay_ledge(i, j, nullptr);
		}
		for (const LedgeCell &cell : _ground.get_ledges()) {
			lay_cell(cell);
		}
		_writer.report();
	}

private:
	void lay_texel(int p_i, int p_j) {
		const HeightBlock &heights = _ground.get_heights();
		const double height = heights.at(p_i, p_j);
		if (!std::isfinite(height)) {
			_result.missing++;
			if (_ground.get_rule().missing == MissingGround::HOLE) {
				_writer.open(p_i, p_j, heights.beside(p_i, p_j));
			}
			return;
		}
		const Eigen::Vector3d given = _normal ? _normal(_ground.place(p_i, p_j)).normalized() : Eigen::Vector3d::Zero();
		const bool is_given = given.allFinite() && given.y() > 0.0;
		_writer.lay(p_i, p_j, height, is_given ? given : _ground.normal(p_i, p_j));
	}

	// Returns the cells of the block that had a ledge in the map and have none now.
	std::vector<std::pair<int, int>> find_gone() {
		std::vector<std::pair<int, int>> gone;
		MapReader codes(_map, MAP_LEDGE);
		const Eigen::Array2i moved = LedgeCell::moved_spots(_map.get_ground_grid());
		const auto is_marked = [&](int p_i, int p_j) {
			for (int n = 0; n < LedgeCell::SPOTS * LedgeCell::SPOTS; n++) {
				const Eigen::Array2i spot =
						LedgeCell::first_spot(p_i, p_j) + moved + Eigen::Array2i(n % LedgeCell::SPOTS, n / LedgeCell::SPOTS);
				if (codes.code(0, spot.x(), spot.y()) != GRASS_LEDGE_NONE) {
					return true;
				}
			}
			return false;
		};
		const Eigen::Array2i first = _ground.get_first() - 1, last = _ground.get_last();
		for (int j = first.y(); j <= last.y() && _map.uses(MAP_LEDGE); j++) {
			for (int i = first.x(); i <= last.x(); i++) {
				if (!_ground.has_ledge(i, j) && is_marked(i, j)) {
					gone.emplace_back(i, j);
				}
			}
		}
		return gone;
	}

	void lay_cell(const LedgeCell &p_cell) {
		std::array<LedgeCorner, 4> corners;
		for (int n = 0; n < 4; n++) {
			const int i = p_cell.i + (n & 1), j = p_cell.j + (n >> 1);
			corners[size_t(n)] = { info_of(MAP_GROUND).value(_map.get_code(MAP_GROUND, 0, i, j)),
				{ info_of(MAP_NORMAL).value(_map.get_code(MAP_NORMAL, 0, i, j)),
						info_of(MAP_NORMAL).value(_map.get_code(MAP_NORMAL, 1, i, j)) },
				!std::isfinite(_ground.get_heights().at(i, j)) };
		}
		_writer.lay_ledge(p_cell.i, p_cell.j, ledge_codes(p_cell, corners, _ground.get_rule().ledge_slope).data());
	}

	PaintMap &_map;
	const GroundReading &_ground;
	const NormalAt &_normal;
	LaidGround &_result;
	GroundWriter _writer;
};

} // namespace

double continued_ground(double p_here, const HeightAt &p_height, const MapRegion &p_field, const Eigen::Vector2d &p_place) {
	constexpr double WITHIN = 1e-3; // metres: rays miss the very edge of a terrain
	const MapRegion inside = p_field.grown(-WITHIN);
	if (std::isfinite(p_here) || inside.contains(p_place)) {
		return p_here;
	}
	const Eigen::Vector2d border = p_place.cwiseMax(inside.min).cwiseMin(inside.max);
	return 2.0 * p_height(border) - p_height(2.0 * border - p_place);
}

bool is_all_ground_in(const PaintMap &p_map, const MapRegion &p_region) {
	const MapRegion region = p_region.grown(1e-6);
	const Eigen::Array2d offset = p_map.get_ground_grid().offset();
	for (const auto &[key, chunk] : p_map.get_chunks()) {
		const MapRegion whole = MapRegion::of_chunk(key);
		const bool is_inside = region.grown(-GROUND_TEXEL).contains(whole.min) && region.grown(-GROUND_TEXEL).contains(whole.max);
		for (const MapChannel channel : { MAP_GROUND, MAP_HOLE, MAP_LEDGE }) {
			const MapChannelInfo &info = info_of(channel);
			const auto &texels = chunk.channels[size_t(channel)];
			for (int n = 0; texels && !is_inside && n < info.side * info.side; n++) {
				const Eigen::Array2d texel(key.x * info.side + n % info.side, key.z * info.side + n / info.side);
				const Eigen::Vector2d place = (texel + 0.5) * info.texel_size() + offset;
				if (read_code(texels->data(), info, size_t(n)) != info.initial[0] && !region.contains(place)) {
					return false;
				}
			}
		}
	}
	return true;
}

LaidGround lay_ground(PaintMap &r_map, const GroundReading &p_ground, const NormalAt &p_normal) {
	LaidGround result;
	result.sampled = p_ground.get_sampled();
	result.out_of_room = p_ground.is_out_of_reach();
	if (!p_ground.is_empty()) {
		GroundLayer(r_map, p_ground, p_normal, result).run();
	}
	return result;
}

LaidGround lay_ground(PaintMap &r_map, const MapRegion &p_region, const HeightAt &p_height, MissingGround p_missing,
		const NormalAt &p_normal, const LedgeSearch &p_search) {
	GroundReading ground(p_region, { p_missing, p_search.slope, !p_search.between, r_map.get_ground_grid() });
	ground.read(p_height, p_search.between);
	return lay_ground(r_map, ground, p_normal);
}

} // namespace grass
