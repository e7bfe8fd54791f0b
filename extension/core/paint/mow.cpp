// SPDX-License-Identifier: MIT
#include "core/paint/mow.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace grass {

namespace {

constexpr int CUT_SIDE = info_of(MAP_CUT).side;
constexpr double CUT_TEXEL = info_of(MAP_CUT).texel_size();
static_assert(CUT_SIDE == info_of(MAP_WEAR).side && CUT_SIDE == info_of(MAP_DENSITY).side);

Eigen::Vector2d centre_of(int p_i, int p_j) {
	return { (p_i + 0.5) * CUT_TEXEL, (p_j + 0.5) * CUT_TEXEL };
}

struct TexelBlock {
	Eigen::Array2i first, last; // both inclusive; empty if first > last
};

// Returns the texels whose centres are in a rectangle, within the map's reach.
TexelBlock texels_within(const Eigen::Vector2d &p_min, const Eigen::Vector2d &p_max) {
	constexpr double REACH = PaintMap::REACH * double(CUT_SIDE);
	const Eigen::Array2d low = (p_min.array() / CUT_TEXEL - 0.5).ceil(), high = (p_max.array() / CUT_TEXEL - 0.5).floor();
	if (!low.allFinite() || !high.allFinite()) {
		return { Eigen::Array2i::Zero(), Eigen::Array2i::Constant(-1) };
	}
	return { low.max(-REACH).min(REACH).cast<int>(), high.max(-REACH - 1.0).min(REACH - 1.0).cast<int>() };
}

void visit(const TexelBlock &p_block, const std::function<void(int p_i, int p_j)> &p_visit) {
	for (int j = p_block.first.y(); j <= p_block.last.y(); j++) {
		for (int i = p_block.first.x(); i <= p_block.last.x(); i++) {
			p_visit(i, j);
		}
	}
}

// What a texel's grass consists of; fast for neighbouring texels.
class Stand {
public:
	Stand(const PaintMap &p_map, const GrassKind &p_kind) :
			_kind(p_kind),
			_density(p_map, MAP_DENSITY),
			_height(p_map, MAP_HEIGHT),
			_wear(p_map, MAP_WEAR),
			_cut(p_map, MAP_CUT),
			_hole(p_map, MAP_HOLE),
			_ground_grid(p_map.get_ground_grid()) {}

	double density(int p_i, int p_j) {
		const double wear = _wear.value(0, p_i, p_j);
		static_assert(CUT_SIDE == 2 * info_of(MAP_HOLE).side);
		const Eigen::Array2i hole = _ground_grid.texel_below(p_i, p_j);
		return _hole.code(0, hole.x(), hole.y()) != 0 ? 0.0 : _density.value(0, p_i, p_j) * (1.0 - wear * wear);
	}
	double uncut(int p_i, int p_j) {
		const Eigen::Vector2d place = centre_of(p_i, p_j);
		const double height = _kind.height_at ? _kind.height_at(place) : _kind.height;
		return height * _height.sample(0, place) * (1.0 - GRASS_WEAR_PRESSES * _wear.value(0, p_i, p_j));
	}
	// Returns the mean height of the grass, metres. [Eq M1]
	double standing(int p_i, int p_j) { return std::min(uncut(p_i, p_j), _cut.value(0, p_i, p_j)); }
	bool is_cut(int p_i, int p_j) {
		const int32_t code = _cut.code(0, p_i, p_j);
		return code != MAP_UNCUT_CODE && info_of(MAP_CUT).value(code) < uncut(p_i, p_j);
	}

private:
	GrassKind _kind;
	MapReader _density, _height, _wear, _cut, _hole;
	GroundGrid _ground_grid;
};

// Writes single codes and records what changed.
class Writer {
public:
	Writer(PaintMap &r_map, BrushResult &r_result) : _map(r_map), _result(r_result) {}

	bool write(MapChannel p_channel, int p_i, int p_j, int32_t p_code) {
		const int32_t before = _map.get_code(p_channel, 0, p_i, p_j);
		if (before == p_code) {
			return false;
		}
		if (!_map.set_code(p_channel, 0, p_i, p_j, p_code)) {
			_result.out_of_room = true;
			return false;
		}
		const Eigen::Vector2d low(p_i * CUT_TEXEL, p_j * CUT_TEXEL), high = low.array() + CUT_TEXEL;
		_result.min = _keys.empty() ? low : Eigen::Vector2d(_result.min.cwiseMin(low));
		_result.max = _keys.empty() ? high : Eigen::Vector2d(_result.max.cwiseMax(high));
		if (p_channel == MAP_CUT) { // metres and shares of wear cannot be added
			_result.amount += (double(p_code) - before) * info_of(p_channel).unit * CUT_TEXEL * CUT_TEXEL;
		}
		_keys.insert(key_of(p_channel, p_i, p_j));
		return true;
	}
	void finish() { _result.changed.assign(_keys.begin(), _keys.end()); }

private:
	PaintMap &_map;
	BrushResult &_result;
	std::set<MapKey> _keys;
};

bool is_within(const MowRegion &p_region, int p_i, int p_j) {
	return p_region.footprint == nullptr || p_region.footprint->get_span(centre_of(p_i, p_j)).has_value();
}

TexelBlock block_of(const MowRegion &p_region) {
	MapRegion block = p_region.rectangle;
	if (p_region.footprint != nullptr) {
		if (p_region.footprint->is_empty()) {
			return { Eigen::Array2i::Zero(), Eigen::Array2i::Constant(-1) };
		}
		block = block.shared({ p_region.footprint->get_min(), p_region.footprint->get_max() });
	}
	return texels_within(block.min, block.max);
}

} // namespace

CutResult cut_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind) {
	CutResult result;
	if (p_region.footprint == nullptr || p_region.footprint->is_empty()) {
		return result;
	}
	const Footprint &footprint = *p_region.footprint;
	Writer writer(r_map, result);
	bool covers_any = false;
	const auto cut = [&](int p_i, int p_j, const Eigen::Vector2d &p_place) {
		const std::optional<Footprint::Span> span = footprint.get_span(p_place);
		if (!span) {
			return;
		}
		covers_any = true;
		const double ground = r_map.sample(MAP_GROUND, 0, p_place);
		const MapChannelInfo &info = info_of(MAP_CUT);
		const int32_t code = info.code(std::max(span->low - ground, 0.0));
		if (span->high < ground || code >= r_map.get_code(MAP_CUT, 0, p_i, p_j) || info.value(code) >= p_kind.tallest) {
			return; // the shape is below the ground or above the grass
		}
		Stand stand(r_map, p_kind);
		const double fallen = stand.standing(p_i, p_j) - info.value(code), share = stand.density(p_i, p_j) * CUT_TEXEL * CUT_TEXEL;
		if (writer.write(MAP_CUT, p_i, p_j, code) && fallen > 0.0 && share > 0.0) {
			result.area += share;
			result.volume += share * fallen;
			result.blades += share * p_kind.per_area;
		}
	};
	visit(block_of(p_region), [&](int p_i, int p_j) { cut(p_i, p_j, centre_of(p_i, p_j)); });
	const Eigen::Vector2d middle = footprint.get_centre();
	if (!covers_any && p_region.rectangle.contains(middle)) {
		const Eigen::Array2d texel = (middle.array() / CUT_TEXEL).floor();
		if ((texel.abs() < PaintMap::REACH * double(CUT_SIDE)).all()) {
			cut(int(texel.x()), int(texel.y()), middle);
		}
	}
	writer.finish();
	return result;
}

double mown_share(const PaintMap &p_map, const MowRegion &p_region, const GrassKind &p_kind) {
	Stand stand(p_map, p_kind);
	double mown = 0.0, all = 0.0;
	visit(block_of(p_region), [&](int p_i, int p_j) {
		const double density = stand.density(p_i, p_j);
		if (density > 0.0 && is_within(p_region, p_i, p_j)) {
			all += density;
			mown += stand.is_cut(p_i, p_j) ? density : 0.0;
		}
	});
	return all > 0.0 ? mown / all : 0.0;
}

BrushResult regrow_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind, double p_height, double p_wear) {
	const WearAt everywhere = [p_wear](const Eigen::Vector2d &) { return p_wear; };
	return regrow_grass(r_map, p_region, p_kind, p_height, p_wear > 0.0 ? everywhere : nullptr);
}

BrushResult regrow_grass(PaintMap &r_map, const MowRegion &p_region, const GrassKind &p_kind, double p_height, const WearAt &p_wear) {
	BrushResult result;
	const TexelBlock block = block_of(p_region);
	const auto codes = [](MapChannel p_channel, double p_value) {
		return std::isnan(p_value) ? 0 : int32_t(std::clamp(std::round(p_value / info_of(p_channel).unit), 0.0, 255.0));
	};
	const int32_t longer = codes(MAP_CUT, p_height);
	Writer writer(r_map, result);
	for (const MapKey &key : r_map.get_keys()) {
		const MapChunk *chunk = r_map.find(key);
		const bool has_cuts = longer > 0 && chunk->channels[MAP_CUT], has_wear = p_wear && chunk->channels[MAP_WEAR];
		const Eigen::Array2i corner = Eigen::Array2i(key.x, key.z) * CUT_SIDE;
		if (!has_cuts && !has_wear) {
			continue;
		}
		visit({ block.first.max(corner), block.last.min(corner + (CUT_SIDE - 1)) }, [&](int p_i, int p_j) {
			const int32_t cut = r_map.get_code(MAP_CUT, 0, p_i, p_j), wear = r_map.get_code(MAP_WEAR, 0, p_i, p_j);
			if ((cut == MAP_UNCUT_CODE && wear == 0) || !is_within(p_region, p_i, p_j)) {
				return;
			}
			if (has_cuts) {
				const bool is_grown = info_of(MAP_CUT).value(cut + longer) >= p_kind.tallest;
				writer.write(MAP_CUT, p_i, p_j, is_grown ? MAP_UNCUT_CODE : std::min(cut + longer, MAP_UNCUT_CODE));
			}
			if (has_wear && wear > 0) {
				const int32_t left = std::max(wear - codes(MAP_WEAR, p_wear(centre_of(p_i, p_j))), 0);
				writer.write(MAP_WEAR, p_i, p_j, left);
				if (left == 0) { // recovered: a chunk without wear uses no memory
					writer.write(MAP_WEAR_REST, p_i, p_j, 0);
				}
			}
		});
	}
	writer.finish();
	return result;
}

} // namespace grass
