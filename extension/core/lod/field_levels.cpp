// SPDX-License-Identifier: MIT
#include "core/lod/field_levels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace grass {

namespace {

using glsl::GRASS_BLADES_OF, glsl::GRASS_SEGMENTS_OF;

// Bounds are wider by this share, and distances by so many metres as well, than they are: a card rounds otherwise than we do.
constexpr float SLACK = 1e-3f, SLACK_METRES = 0.01f;
// Needs are bounded in rings around a camera, each so many times as wide as the one within it. More: looser bounds.
constexpr float RING = 1.4f;
// A level is left out if drawing the tiles of the whole field with its next finer mesh takes at most so many vertices more: then its draw
// would cost more than they do.
constexpr int64_t SPARED_VERTICES = 4096;
// How many surfaces a mesh may have that are not needed, and how many must be needed for it to have all of them: large meshes are not made
// again for each other set.
constexpr int SPARE_SURFACES = 1, MANY_SURFACES = 20;

// The least and the most that tiles need.
struct NeedRange {
	LodNeed low{ INFINITY, INFINITY, INFINITY }, high;

	void add(const NeedRange &p_other) {
		low.blades = std::min(low.blades, p_other.low.blades);
		low.segments = std::min(low.segments, p_other.low.segments);
		high.blades = std::max(high.blades, p_other.high.blades);
		high.segments = std::max(high.segments, p_other.high.segments);
	}
};

// Two numbers, the lower one first.
struct Range {
	float low, high;
};

// [Eq L7] [Eq L9] Returns the greatest value of a share times grass_lod_ends(): of a parabola, up to where grass_lod_ends() is 1.
float most_in_sight(float p_heights, const Range &p_share, float p_carries) {
	const float turn = float(GRASS_FAR_LOW) - float(GRASS_FAR_GONE) / std::max(p_heights, 1e-6f);
	const float best = std::clamp(turn / (2.0f * (float(GRASS_FAR_LOW) - 1.0f)), p_share.low, p_share.high);
	const float left = grass_lod_ends(p_heights, best, p_carries);
	return left >= 1.0f ? p_share.high : best * left;
}

// Bounds what the tiles of a field need of one camera.
class CameraNeeds {
public:
	CameraNeeds(const CullField &p_field, const FieldView &p_view, const ViewCamera &p_camera, const TileCover::Tile &p_ground) :
			_field(p_field), _view(p_view), _camera(p_camera), _ground(p_ground) {
		const float x = 0.5f * float(p_field.grid.get_size_x()), z = 0.5f * float(p_field.grid.get_size_z()), y = 0.5f * p_field.height;
		_middles = { Eigen::Vector3f(-x, y + p_ground.low, -z), Eigen::Vector3f(x, y + p_ground.high, z) };
		_above = { p_camera.eye.y() - _middles.max().y(), p_camera.eye.y() - _middles.min().y() };
	}

	// Passes the needs in each ring up to p_farthest metres to p_take.
	template <class Take> void visit(bool p_casts, float p_farthest, const Take &p_take) const {
		const Eigen::Vector3f to_middle = _camera.eye - _middles.center();
		const float end = std::min((to_middle.cwiseAbs() + 0.5f * _middles.sizes()).norm() * (1.0f + SLACK) + SLACK_METRES, p_farthest);
		float begin = std::max(_middles.exteriorDistance(_camera.eye) * (1.0f - SLACK) - SLACK_METRES, 0.0f);
		while (begin < end) {
			const float until = std::min(std::max(RING * begin, _camera.near + SLACK_METRES), end);
			p_take(find(p_casts, { begin, until }));
			begin = until;
		}
	}

private:
	NeedRange find(bool p_casts, const Range &p_ring) const {
		const bool has_eye = _camera.pixel_slope > 0.0f;
		const Range at{ std::max(p_ring.low, _camera.near), std::max(p_ring.high, _camera.near) * (1.0f + SLACK) };
		const Range shown = p_casts || !has_eye || _view.lod.pixels_min <= 0.0f ? Range{ 1.0f, 1.0f } : in_sight(p_ring.low, at);
		const auto lod_at = [&](float p_distance) { return p_casts ? _view.lod.of_shadows(p_distance, _view.shadow_distance) : _view.lod; };
		const float near = _camera.near;
		NeedRange need;
		need.low = {};
		need.low.add(lod_at(at.high), _field.size, has_eye ? at.high : near, near, _camera.pixel_at(at.high), shown.low);
		need.high.add(lod_at(at.low), _field.size, has_eye ? at.low : near, near, _camera.pixel_at(at.low), shown.high);
		need.low.blades *= 1.0f - SLACK;
		need.low.segments *= 1.0f - SLACK;
		need.high.blades = std::min(need.high.blades * (1.0f + SLACK), float(GRASS_BLADES_PER_TILE));
		need.high.segments *= 1.0f + SLACK;
		return need;
	}

	// [Eq L7] [Eq L9] Returns the least and the greatest share of its blades that a tile needs. p_begin: of the ring, metres; p_at:
	// distances of tiles in it.
	Range in_sight(float p_begin, const Range &p_at) const {
		const float tallest = _field.size.length, lowest = std::min(tallest, _ground.cut);
		const float tile_size = float(_field.grid.get_tile_size()), farthest = std::max(std::abs(_above.low), std::abs(_above.high));
		const float away = std::sqrt(std::max(p_begin * p_begin - farthest * farthest, 0.0f));
		const float dense = grass_lod_cover(_field.size.width, tallest, tile_size);
		const float sparse = _ground.grown * grass_lod_cover(_field.size.width, lowest, tile_size);
		Range share{ grass_lod_in_sight(dense, p_at.high, _above.low, tallest, 0.0f), 0.0f };
		for (const float at : { away, p_at.high }) {
			share.high = std::max(share.high, grass_lod_in_sight(sparse, at, _above.high, lowest, _ground.slope));
		}
		share = { share.low * (1.0f - SLACK), std::min(share.high * (1.0f + SLACK), 1.0f) };
		const float carries = _view.lod.is_carried ? 1.0f : 0.0f;
		const auto heights_at = [&](float p_height, float p_distance) {
			return p_height / (_view.lod.pixels_min * _camera.pixel_at(p_distance));
		};
		return { share.low * grass_lod_ends(heights_at(lowest, p_at.high), share.high, carries),
			most_in_sight(heights_at(tallest, p_at.low) * (1.0f + SLACK), share, carries) };
	}

	const CullField &_field;
	const FieldView &_view;
	const ViewCamera &_camera;
	const TileCover::Tile &_ground;
	Eigen::AlignedBox3f _middles; // around the middles of all tiles' boxes
	Range _above; // the eye above the highest and the lowest of them, metres
};

// Returns the levels in [p_first, p_end) of tiles with such needs.
LevelSet levels_of(const NeedRange &p_need, int p_first, int p_end) {
	if (p_need.high.blades <= 0.0f) {
		return 0;
	}
	const int finest = get_lod_level(p_first).segments;
	const int most = std::min(grass_lod_segments(p_need.high.segments), finest);
	const int fewest = std::min(grass_lod_segments(p_need.low.segments), finest);
	const float high = grass_lod_shown(p_need.high.blades, p_need.high.blades < 1.0f ? 0.0f : 1.0f);
	const float low = grass_lod_shown(p_need.low.blades, p_need.low.blades < 1.0f ? 1.0f : 0.0f);
	LevelSet levels = 0;
	for (int level = p_first; level < p_end; level++) {
		const int segments = GRASS_SEGMENTS_OF[level], next = level + 1;
		if (segments < fewest || segments > most || float(GRASS_BLADES_OF[level]) < low) {
			continue;
		}
		const bool is_last = next == p_end || GRASS_SEGMENTS_OF[next] != segments;
		levels |= is_last || float(GRASS_BLADES_OF[next]) < high ? LevelSet(1) << level : 0;
	}
	return levels;
}

// Leaves out levels in [p_first, p_end) whose draw would cost more than it spares.
LevelSet merge(LevelSet p_levels, int64_t p_tiles, int p_first, int p_end) {
	LodLevel finer{ 0, 0 };
	LevelSet merged = 0;
	for (int level = p_first; level < p_end; level++) {
		const LevelSet bit = p_levels & (LevelSet(1) << level);
		const LodLevel mesh = get_lod_level(level);
		const bool is_spared =
				mesh.segments == finer.segments && p_tiles * (finer.blades - mesh.blades) * (2 * mesh.segments + 1) <= SPARED_VERTICES;
		if (bit != 0 && !is_spared) {
			merged |= bit;
			finer = mesh;
		}
	}
	return merged;
}

// Returns whether the field, or a shadow of it, may be in a camera's view.
bool may_cast_into(const CullField &p_field, const FieldView &p_view, const ViewCamera &p_camera, const TileCover::Tile &p_ground) {
	const Eigen::Vector3f half(0.5f * float(p_field.grid.get_size_x()) + p_field.overhang,
			0.5f * (p_field.height + p_ground.high - p_ground.low), 0.5f * float(p_field.grid.get_size_z()) + p_field.overhang);
	const Eigen::Vector3f wider = half * (1.0f + SLACK) + Eigen::Vector3f::Constant(SLACK_METRES);
	return casts_into(p_view, p_camera, Eigen::Vector3f(0.0f, p_ground.low + half.y(), 0.0f), wider);
}

// Finds the levels for several cameras. The needs of a tile combine, so only the range of all together counts.
LevelSet find_some_levels(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground, bool p_casts) {
	const int first = p_casts ? GRASS_LOD_LEVELS : 0, end = p_casts ? GRASS_ALL_LEVELS : GRASS_LOD_LEVELS;
	LevelSet levels = 0;
	NeedRange all;
	for (const ViewCamera &camera : p_view.cameras) {
		if (!p_casts || may_cast_into(p_field, p_view, camera, p_ground)) {
			const float farthest = p_casts ? p_view.shadow_distance : INFINITY;
			CameraNeeds(p_field, p_view, camera, p_ground).visit(p_casts, farthest, [&](const NeedRange &p_need) {
				levels |= levels_of(p_need, first, end);
				all.add(p_need);
			});
		}
	}
	if (p_view.cameras.size() > 1) {
		levels = levels_of(all, first, end);
	}
	return merge(levels, p_field.grid.get_tile_count(), first, end);
}

} // namespace

LevelSet find_levels(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground) {
	if (p_ground.is_bare()) {
		return 0;
	}
	return find_some_levels(p_field, p_view, p_ground, false) | find_some_levels(p_field, p_view, p_ground, true);
}

LevelSet find_surfaces(LevelSet p_now, LevelSet p_needed, LevelSet p_all) {
	const LevelSet now = p_now & p_all, needed = p_needed & p_all;
	if (needed == 0) {
		return now; // nothing is drawn
	}
	const LevelSet wanted = std::popcount(needed) > MANY_SURFACES ? p_all : needed;
	return (needed & ~now) == 0 && std::popcount(now) <= std::popcount(wanted) + SPARE_SURFACES ? now : wanted;
}

bool is_within(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground, float p_distance) {
	const Eigen::Vector3f half(0.5f * float(p_field.grid.get_size_x()), 0.0f, 0.5f * float(p_field.grid.get_size_z()));
	const Eigen::AlignedBox3f roots{ Eigen::Vector3f(Eigen::Vector3f(0.0f, p_ground.low, 0.0f) - half),
		Eigen::Vector3f(Eigen::Vector3f(0.0f, p_ground.high, 0.0f) + half) };
	return std::ranges::any_of(p_view.cameras,
			[&](const ViewCamera &p_camera) { return roots.exteriorDistance(p_camera.eye) * (1.0f - SLACK) - SLACK_METRES < p_distance; });
}

} // namespace grass
