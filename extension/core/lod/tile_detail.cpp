// SPDX-License-Identifier: MIT
#include "core/lod/tile_detail.h"

#include "core/base/hash.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grass {

namespace {

// A tile keeps its blades until an eye is farther away than its number requires by so many times SLACK, and by this share of the distance.
constexpr float KEPT_SLACKS = 3.0f, KEPT_SHARE = 0.1f;
// Changes of the coarseness by a smaller share wait for more. Smaller: the awake tiles are looked at more often.
constexpr float LEAST_CHANGE = 0.03f;

int round_up(float p_blades) {
	const int steps = int(std::ceil(p_blades / float(GRASS_DETAIL_BLADES)));
	return std::clamp(steps * GRASS_DETAIL_BLADES, GRASS_DETAIL_BLADES, GRASS_BLADES_PER_TILE);
}

bool has_same_lens(const ViewCamera &p_a, const ViewCamera &p_b) {
	return p_a.near == p_b.near && p_a.pixel == p_b.pixel && p_a.pixel_slope == p_b.pixel_slope;
}

// Returns the distance at which a camera sees the tile once its eye has come nearer by p_slack metres. p_share: and by this share of it.
float nearest(const ViewCamera &p_camera, float p_away, float p_slack, float p_share) {
	return std::max(p_away * (1.0f - p_share) - p_slack, p_camera.near);
}

} // namespace

bool TileDetail::forget_asked() {
	for (auto &[tile, frames] : _asked) {
		frames--;
	}
	return std::erase_if(_asked, [](const auto &p_asked) { return p_asked.second <= 0; }) > 0;
}

bool TileDetail::see_all() {
	const bool changes = !_sees_all;
	_sees_all = true;
	_is_known = false;
	_cover.reset();
	return changes;
}

bool TileDetail::is_near(const CullField &p_field, const FieldView &p_view, const std::shared_ptr<const TileCover> &p_cover) const {
	return _is_known && p_field.grid == _field.grid && _cover == p_cover && p_view.lod == _view.lod &&
			p_view.shadow_distance == _view.shadow_distance &&
			std::ranges::equal(p_view.cameras, _view.cameras, [](const ViewCamera &p_a, const ViewCamera &p_b) {
				return has_same_lens(p_a, p_b) && (p_a.eye - p_b.eye).norm() <= SLACK;
			});
}

bool TileDetail::see(const CullField &p_field, const FieldView &p_view, const std::shared_ptr<const TileCover> &p_cover) {
	const bool has_forgotten = forget_asked();
	if (p_view.cameras.empty()) {
		return see_all() || has_forgotten;
	}
	if (is_near(p_field, p_view, p_cover)) {
		return has_forgotten;
	}
	_sees_all = false;
	_is_known = true;
	_field = p_field;
	_view = p_view;
	_cover = p_cover;
	return true;
}

bool TileDetail::set_coarseness(float p_coarseness) {
	const float coarseness = p_coarseness > 1.0f ? p_coarseness : 1.0f; // NaN: 1
	const bool is_end = coarseness == 1.0f && _coarseness != 1.0f;
	if (!is_end && std::abs(coarseness - _coarseness) < LEAST_CHANGE * _coarseness) {
		return false;
	}
	_coarseness = coarseness;
	return !_sees_all;
}

bool TileDetail::ask(int p_tile) {
	return !_sees_all && std::exchange(_asked[p_tile], FRAMES_ASKED) == 0;
}

int TileDetail::blades_of(int p_x, int p_z, int p_now) const {
	if (_sees_all || (!_asked.empty() && _asked.contains(_field.grid.get_index(p_x, p_z)))) {
		return GRASS_BLADES_PER_TILE;
	}
	return kept_blades(p_x, p_z, p_now, _view.lod);
}

int TileDetail::simulated_of(int p_x, int p_z, int p_now, int p_drawn) const {
	const bool is_asked = !_asked.empty() && _asked.contains(_field.grid.get_index(p_x, p_z));
	if (_sees_all || is_asked || _coarseness <= 1.0f || p_drawn <= GRASS_DETAIL_BLADES || is_within(p_x, p_z, FINE_DISTANCE)) {
		return p_drawn;
	}
	return std::min(p_drawn, kept_blades(p_x, p_z, p_now, coarse_lod()));
}

// Returns the detail of the simulation. The coarseness is added instead of multiplied, so that it also works where pixels_min is 0.
LodParams TileDetail::coarse_lod() const {
	LodParams lod = _view.lod;
	lod.pixels_min += (_coarseness - 1.0f) * float(PIXELS_MIN.initial);
	return lod;
}

int TileDetail::kept_blades(int p_x, int p_z, int p_now, const LodParams &p_lod) const {
	const TileCover::Tile ground = _cover ? _cover->get(p_x, p_z) : TileCover::FULL;
	if (ground.is_bare()) {
		return GRASS_DETAIL_BLADES;
	}
	const int least = blades_within(p_x, p_z, ground, SLACK, p_lod);
	if (p_now <= least) {
		return least;
	}
	return std::min(p_now, blades_within(p_x, p_z, ground, KEPT_SLACKS * SLACK, p_lod));
}

bool TileDetail::is_within(int p_x, int p_z, double p_distance) const {
	if (_sees_all) {
		return true;
	}
	const Eigen::Vector3f middle = middle_of(p_x, p_z, _cover ? _cover->get(p_x, p_z) : TileCover::FULL);
	return std::ranges::any_of(
			_view.cameras, [&](const ViewCamera &p_camera) { return (p_camera.eye - middle).norm() <= float(p_distance) + SLACK; });
}

// Returns the middle of the tile's box, field space, metres.
Eigen::Vector3f TileDetail::middle_of(int p_x, int p_z, const TileCover::Tile &p_ground) const {
	const float half_height = 0.5f * (_field.height + p_ground.high - p_ground.low);
	return _field.grid.get_centre(p_x, p_z).cast<float>() + Eigen::Vector3f(0.0f, p_ground.low + half_height, 0.0f);
}

// Returns what the tile needs while each eye is within p_slack metres.
int TileDetail::blades_within(int p_x, int p_z, const TileCover::Tile &p_ground, float p_slack, const LodParams &p_lod) const {
	const Eigen::Vector3f middle = middle_of(p_x, p_z, p_ground);
	const float share = p_slack > SLACK ? KEPT_SHARE : 0.0f;
	LodNeed need;
	for (const ViewCamera &camera : _view.cameras) {
		const float distance = nearest(camera, (camera.eye - middle).norm(), p_slack, share);
		const float pixel = camera.pixel_at(distance), lod_distance = camera.pixel_slope > 0.0f ? distance : camera.near;
		const Eigen::Vector3f to_eye = camera.eye - middle;
		const float along = std::max(std::hypot(to_eye.x(), to_eye.z()) * (1.0f - share) - p_slack, 0.0f);
		const float shown = lod_in_sight(_field, camera, p_lod, p_ground, along, to_eye.y() + p_slack, pixel);
		need.add(p_lod, _field.size, lod_distance, camera.near, pixel, shown);
		if (distance < _view.shadow_distance) {
			need.add(p_lod.of_shadows(distance, _view.shadow_distance), _field.size, lod_distance, camera.near, pixel);
		}
	}
	return round_up(grass_lod_shown(need.blades, grass_tile_hash(uint32_t(p_x), uint32_t(p_z), _field.seed)));
}

size_t TileDetail::get_memory_usage() const {
	return _asked.size() * (sizeof(std::pair<int, int>) + 2 * sizeof(void *)) + _view.cameras.capacity() * sizeof(ViewCamera) +
			_view.falls.capacity() * sizeof(Eigen::Vector3f);
}

} // namespace grass
