// SPDX-License-Identifier: MIT
#include "editor/ground_watch.h"

#include "core/base/cpu_clock.h"
#include "core/fill/fill.h"
#include "editor/field_owner.h"
#include "editor/toast.h"
#include "physics/ground_rays.h"
#include "shared/convert.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// Frames of a round, which checks each body once. A body that is the same in two rounds is at rest. More: the grass follows later. Less: a
// scene of thousands of bodies makes the editor slow.
constexpr int FRAMES_A_ROUND = 15;
// Rounds between searches for new bodies. More: misses a body that is moved soon after it was added.
constexpr int ROUNDS_A_SEARCH = 8;
// Rays a frame, at most: some milliseconds. More: the editor stutters.
constexpr int64_t RAYS_A_FRAME = 4096;
// Changes smaller than this area are read everywhere, larger ones only in chunks that have ground: the unpainted rest of a large field
// stays unread. m^2.
constexpr double LARGEST_REGION = 65536.0;
constexpr double TEXEL = info_of(MAP_GROUND).texel_size();
// A body this large is ground. A smaller one may be a house with grass around it. m^2.
constexpr double TERRAIN = 1000.0;

// Returns whether the map has ground. Level ground at the field's height leaves no trace in the map; small fields are baked as a whole with
// their first stroke. The field itself reads the ground of a terrain.
bool has_ground(const GrassField &p_field) {
	const Vector2 size = p_field.get_parts().settings.get_size();
	return p_field.get_parts().sources.get_terrain().is_empty() && p_field.get_map().is_valid() &&
			(p_field.get_map()->get_map().uses(MAP_GROUND) || size.x * size.y <= LARGEST_REGION);
}

std::vector<uint64_t> ids_of_fields(Node *p_root) {
	std::vector<uint64_t> fields;
	const auto add = [&](Object *p_node) {
		const GrassField *field = Object::cast_to<GrassField>(p_node);
		if (field != nullptr && has_ground(*field)) {
			fields.push_back(field->get_instance_id());
		}
	};
	add(p_root);
	const TypedArray<Node> nodes = p_root->find_children("*", "GrassField"); // saved ones only: the plots of a world are not saved
	for (int64_t i = 0; i < nodes.size(); i++) {
		add(nodes[i]);
	}
	return fields;
}

MapRegion region_of(const GrassField &p_field) {
	const Eigen::Vector2d half = 0.5 * to_eigen(p_field.get_parts().settings.get_size());
	return MapRegion{ -half, half }.grown(TEXEL); // includes the texels that the outermost blades blend with
}

// Returns the region below and above a box in the field's space.
MapRegion footprint(const Eigen::AlignedBox3d &p_box) {
	return { { p_box.min().x(), p_box.min().z() }, { p_box.max().x(), p_box.max().z() } };
}

// Returns whether the map's ground is on the body somewhere, and not only below it. p_box: of the body, field space.
bool is_stood_on(const GrassField &p_field, const Eigen::AlignedBox3d &p_box) {
	const MapRegion region = footprint(p_box).shared(region_of(p_field));
	if (!region.has_area() || (region.max - region.min).prod() >= TERRAIN) {
		return region.has_area();
	}
	const PaintMap &map = p_field.get_map()->get_map();
	for (double z = region.min.y(); z < region.max.y(); z += TEXEL) {
		for (double x = region.min.x(); x < region.max.x(); x += TEXEL) {
			const double height = map.sample(MAP_GROUND, 0, { x, z });
			if (height > p_box.center().y() && height < p_box.max().y() + TEXEL) {
				return true;
			}
		}
	}
	return false;
}

} // namespace

void GroundWatch::forget() {
	_root_id = 0;
	_field_ids.clear();
	_bodies.clear();
	_poses.clear();
	_pieces.clear();
	_next_body = 0;
	_frames_left = _rounds_left = 0;
	_is_told = false;
}

void GroundWatch::update(Node *p_root) {
	CpuClock clock;
	if (--_frames_left <= 0) {
		_look_us = 0.0;
		_frames_left = begin_round(p_root) ? FRAMES_A_ROUND : 2 * FRAMES_A_ROUND;
	}
	look(_bodies.size() / FRAMES_A_ROUND + 1);
	_look_us = std::max(_look_us, 1000.0 * clock.lap());
	const int64_t before = _rays;
	read(RAYS_A_FRAME);
	_most_rays = std::max(_most_rays, _rays - before);
}

void GroundWatch::finish(Node *p_root) {
	for (int round = 0; round < 2; round++) { // after two rounds everything that moved is at rest
		if (begin_round(p_root)) {
			look(_bodies.size());
		}
	}
	read(GroundPlaces::ALL - _rays);
}

// Returns false if there is nothing to watch.
bool GroundWatch::begin_round(Node *p_root) {
	_field_ids = p_root == nullptr ? std::vector<uint64_t>() : ids_of_fields(p_root);
	if (_field_ids.empty()) {
		forget();
		return false;
	}
	const bool is_first = _root_id != p_root->get_instance_id();
	if (is_first) {
		const std::vector<uint64_t> ids = _field_ids;
		forget();
		_field_ids = ids;
		_root_id = p_root->get_instance_id();
	}
	look_at_fields();
	_next_body = 0;
	if (--_rounds_left <= 0) {
		_rounds_left = ROUNDS_A_SEARCH;
		for (const uint64_t id : find_ground_bodies(p_root)) {
			Watched<GroundBody> &body = _bodies[id];
			if (is_first) {
				body.baked = body.last = read_ground_body(Object::cast_to<Node3D>(ObjectDB::get_instance(id)), GroundBody());
			}
		}
	}
	return true;
}

// Checks the next p_count bodies of this round.
void GroundWatch::look(size_t p_count) {
	auto entry = _bodies.lower_bound(_next_body);
	for (; entry != _bodies.end() && p_count > 0; p_count--) {
		look_at_body(entry->first, entry->second);
		const bool is_gone = ObjectDB::get_instance(entry->first) == nullptr && entry->second.baked.shapes.empty();
		entry = is_gone ? _bodies.erase(entry) : std::next(entry);
	}
	_next_body = entry == _bodies.end() ? std::numeric_limits<uint64_t>::max() : entry->first;
}

void GroundWatch::look_at_body(uint64_t p_id, Watched<GroundBody> &r_body) {
	const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(p_id));
	// Undo may restore a body that was removed from the scene.
	const GroundBody now = node == nullptr ? GroundBody() : read_ground_body(node, r_body.last);
	if (r_body.last == now && !(r_body.baked == now)) {
		add_body(r_body, now);
	}
	r_body.last = now;
}

void GroundWatch::look_at_fields() {
	for (const GrassField *field : find_fields()) {
		const bool is_new = _poses.find(field->get_instance_id()) == _poses.end();
		Watched<Transform3D> &pose = _poses[field->get_instance_id()];
		const Transform3D now = field->field_transform();
		if (is_new) {
			pose.baked = now;
		} else if (pose.last == now && pose.baked != now) {
			add_pieces(*field, region_of(*field), Eigen::AlignedBox3d());
			pose.baked = now;
		}
		pose.last = now;
	}
}

std::vector<const GrassField *> GroundWatch::find_fields() const {
	std::vector<const GrassField *> fields;
	for (const uint64_t id : _field_ids) {
		const GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(id));
		if (field != nullptr && field->is_inside_tree() && has_ground(*field)) {
			fields.push_back(field);
		}
	}
	return fields;
}

void GroundWatch::add_body(Watched<GroundBody> &r_body, const GroundBody &p_now) {
	const Eigen::AlignedBox3d before = r_body.baked.get_box(), now = p_now.get_box();
	r_body.baked = p_now;
	for (const GrassField *field : find_fields()) {
		const Eigen::Affine3d to_field = to_eigen(field->field_transform()).inverse(Eigen::Isometry);
		const Eigen::AlignedBox3d left = before.isEmpty() ? before : before.transformed(to_field);
		r_body.is_ground = r_body.is_ground || (!left.isEmpty() && is_stood_on(*field, left));
		if (!r_body.is_ground) {
			continue;
		}
		if (!left.isEmpty()) {
			add_pieces(*field, footprint(left).grown(GroundReading::REACH * TEXEL), left);
		}
		if (!now.isEmpty()) {
			add_pieces(*field, footprint(now.transformed(to_field)).grown(GroundReading::REACH * TEXEL), Eigen::AlignedBox3d());
		}
	}
}

// Returns whether the scene would save the ground: otherwise it is not read.
bool GroundWatch::may_lay(const GrassField &p_field) {
	const auto foreign = find_foreign(p_field);
	if (foreign && !std::exchange(_is_told, true)) {
		toast(vformat("GrassField '%s': the ground below it is not read again, since %s a part of %s, which this scene does not save.%s",
				p_field.get_name(), foreign->has_own_properties ? "its map is" : "it is", foreign->file.get_file(),
				foreign->has_own_properties ? " Choose Make Unique in the menu at the toolbar's end, or open that scene." : ""));
	}
	return !foreign;
}

void GroundWatch::add_pieces(const GrassField &p_field, const MapRegion &p_region, const Eigen::AlignedBox3d &p_left) {
	const MapRegion region = p_region.shared(region_of(p_field));
	if (!region.has_area() || !may_lay(p_field)) {
		return;
	}
	if (!_pieces.empty()) { // what was read of it is of the moment before
		_pieces.front().reading.reset();
	}
	const bool is_large = (region.max - region.min).prod() > LARGEST_REGION;
	const auto before = p_left.isEmpty() ? nullptr : std::make_shared<const PaintMap>(p_field.get_map()->get_map());
	for (const MapKey &key : chunks_in(region)) {
		const MapChunk *chunk = p_field.get_map()->get_map().find(key);
		const MapRegion part = MapRegion::of_chunk(key).shared(region);
		if (part.has_area() && (!is_large || (chunk != nullptr && chunk->channels[MAP_GROUND]))) {
			_pieces.push_back({ p_field.get_instance_id(), part, p_left, before, {} });
		}
	}
}

void GroundWatch::read(int64_t p_most) {
	const int64_t end = _rays + p_most;
	while (!_pieces.empty() && end - _rays >= GroundReading::LEAST_PLACES && read_on(end - _rays)) {
	}
}

// Returns whether the first piece is done. Where no ground is left, grass keeps its height (the map may have heights without a body),
// unless it stood on the body that has gone: then it comes down to the field's plane.
bool GroundWatch::read_on(int64_t p_most) {
	Piece &piece = _pieces.front();
	const GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(piece.field_id));
	const bool is_there = field != nullptr && field->is_inside_tree() && has_ground(*field);
	GroundRays rays(is_there ? field->get_world_3d() : Ref<World3D>(), is_there ? field->field_transform() : Transform3D());
	if (!rays.is_usable()) {
		_pieces.pop_front();
		return true;
	}
	rays.keep_within(field->get_parts().settings.get_ground_band());
	Eigen::AlignedBox3d left = piece.left;
	if (!left.isEmpty()) { // heights in the map are rounded
		left.min().y() -= TEXEL;
		left.max().y() += TEXEL;
	}
	const HeightAt ray = [&](const Eigen::Vector2d &p_place) { return rays.height_at_corner(p_place); };
	const MapRegion ground = region_of(*field).grown(-TEXEL);
	const auto height_at = [&](const Eigen::Vector2d &p_place) {
		const double height = continued_ground(ray(p_place), ray, ground, p_place);
		const double before = std::isnan(height) && piece.before ? piece.before->sample(MAP_GROUND, 0, p_place) : 0.0;
		const bool comes_down = before != 0.0 && left.contains(Eigen::Vector3d(p_place.x(), before, p_place.y()));
		return comes_down ? 0.0 : height;
	};
	const GroundGrid &grid = field->get_map()->get_map().get_ground_grid();
	if (!piece.reading || !(piece.reading->get_rule().grid == grid)) {
		piece.reading.emplace(
				piece.region, GroundRule{ MissingGround::STAYS, field->get_parts().settings.get_param(PARAM_LEDGE_SLOPE), false, grid });
	}
	const int64_t sampled = piece.reading->get_sampled();
	const bool is_done = piece.reading->read(height_at, height_at, p_most);
	_rays += piece.reading->get_sampled() - sampled;
	if (is_done) {
		const GroundReading reading = std::move(*piece.reading);
		_pieces.pop_front();
		lay(field->get_map(), reading);
	}
	return is_done;
}

void GroundWatch::lay(const Ref<GrassMap> &p_map, const GroundReading &p_ground) {
	const LaidGround laid = p_map.ptr()->change([&](PaintMap &r_map) { return lay_ground(r_map, p_ground); });
	if (!laid.changed.empty()) {
		EditorInterface::get_singleton()->set_object_edited(p_map.ptr(), true);
	}
}

} // namespace grass
