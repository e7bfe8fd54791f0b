// SPDX-License-Identifier: MIT
#include "resources/grass_bone_colliders_3d.h"

#include "shared/bind_property.h"
#include "shared/convert.h"
#include "shared/params.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/object.hpp>

#include <optional>

using namespace godot;

namespace grass {

namespace {

// Nodes enter and leave on the main thread. Keyed by their ids.
std::map<uint64_t, GrassBoneColliders3D *> skeletons_in_tree;

// Ticks between reads of the places of all bones while the skeleton is far from every field. More: bones that swing far out of their box
// bend grass later.
constexpr uint64_t BONES_LOOK_EVERY = 8;

} // namespace

const std::map<uint64_t, GrassBoneColliders3D *> &GrassBoneColliders3D::get_all() {
	return skeletons_in_tree;
}

// Returns the skeleton that `skeleton` names, or the parent if it names none.
const Skeleton3D *GrassBoneColliders3D::find_skeleton() const {
	if (!is_inside_tree()) {
		return nullptr;
	}
	return Object::cast_to<Skeleton3D>(_skeleton.is_empty() ? get_parent() : get_node_or_null(_skeleton));
}

// Finds the skeleton and its place in this tick, once for all fields; null: none. Listeners of one field may free it before the next one
// looks.
const Skeleton3D *GrassBoneColliders3D::see(int64_t &r_calls) {
	const uint64_t tick = Engine::get_singleton()->get_physics_frames();
	const bool is_new_tick = _seen.tick != tick, was_seen = _seen.skeleton != 0;
	const Skeleton3D *skeleton = nullptr;
	if (!is_new_tick) {
		skeleton = was_seen ? Object::cast_to<Skeleton3D>(ObjectDB::get_instance(_seen.skeleton)) : nullptr;
	} else if (_enabled) {
		skeleton = find_skeleton();
		r_calls += 2;
	}
	_seen.tick = tick;
	_seen.skeleton = skeleton != nullptr ? skeleton->get_instance_id() : 0;
	if (skeleton == nullptr) {
		_seen.box.setEmpty();
		_seen.bones.clear();
	} else if (is_new_tick) {
		const Transform3D to_world = skeleton->get_global_transform();
		r_calls++;
		_seen.way = was_seen ? (to_world.origin - _seen.to_world.origin).length() : 0.0;
		_seen.to_world = to_world;
	}
	return skeleton;
}

Eigen::AlignedBox3d GrassBoneColliders3D::find_bounds(int64_t &r_calls) {
	const Skeleton3D *skeleton = see(r_calls);
	if (skeleton == nullptr) {
		return {};
	}
	if (_seen.bones_tick == NEVER || _seen.tick - _seen.bones_tick >= BONES_LOOK_EVERY) {
		read_bones(*skeleton, r_calls);
	}
	if (_seen.box.isEmpty()) {
		return {};
	}
	const Eigen::Affine3d to_world = to_eigen(_seen.to_world);
	const Eigen::Vector3d middle = to_world * _seen.box.center();
	const Eigen::Vector3d half = to_world.linear().cwiseAbs() * (0.5 * _seen.box.sizes()) + Eigen::Vector3d::Constant(_seen.way);
	return { middle - half, middle + half };
}

const std::vector<GrassBoneColliders3D::Bone> &GrassBoneColliders3D::find_bones(int64_t &r_calls) {
	const Skeleton3D *skeleton = see(r_calls);
	if (skeleton != nullptr && _seen.bones_tick != _seen.tick) {
		read_bones(*skeleton, r_calls);
	}
	return _seen.bones;
}

// Returns whether `bones` includes the bone.
bool GrassBoneColliders3D::has_bone(const Skeleton3D &p_skeleton, int p_bone, int64_t &r_calls) const {
	r_calls += _bones.is_empty() ? 0 : 1;
	return _bones.is_empty() || _bones.has(p_skeleton.get_bone_name(p_bone));
}

void GrassBoneColliders3D::read_bones(const Skeleton3D &p_skeleton, int64_t &r_calls) {
	const int count = p_skeleton.get_bone_count();
	r_calls += 1 + count; // and the parent of each
	std::vector<std::optional<Vector3>> places(size_t(count), std::nullopt); // in the skeleton
	const auto place_of = [&](int p_bone) {
		std::optional<Vector3> &place = places[size_t(p_bone)];
		if (!place) {
			r_calls++;
			place = p_skeleton.get_bone_global_pose(p_bone).origin;
		}
		return *place;
	};
	_seen.bones.clear();
	_seen.bones_tick = _seen.tick;
	_seen.box.setEmpty();
	for (int i = 0; i < count; i++) {
		const int parent = p_skeleton.get_bone_parent(i);
		if (parent < 0 || !has_bone(p_skeleton, parent, r_calls)) {
			continue;
		}
		const Vector3 local_from = place_of(parent), local_to = place_of(i);
		const Vector3 from = _seen.to_world.xform(local_from), to = _seen.to_world.xform(local_to);
		const double length = (to - from).length(), local_length = (local_to - local_from).length();
		if (length < _length_min || length <= 0.0) {
			continue;
		}
		_seen.bones.push_back({ i, from, to, _thickness * length });
		const Eigen::Vector3d around = Eigen::Vector3d::Constant(_thickness * local_length);
		for (const Eigen::Vector3d &end : { to_eigen(local_from), to_eigen(local_to) }) {
			_seen.box.extend(Eigen::Vector3d(end - around));
			_seen.box.extend(Eigen::Vector3d(end + around));
		}
	}
}

void GrassBoneColliders3D::set_skeleton(const NodePath &p_skeleton) {
	if (replace(_skeleton, p_skeleton)) {
		forget();
		update_configuration_warnings();
	}
}

void GrassBoneColliders3D::set_bones(const PackedStringArray &p_bones) {
	if (replace(_bones, p_bones)) {
		forget();
		update_configuration_warnings();
	}
}

void GrassBoneColliders3D::set_thickness(double p_thickness) {
	_thickness = checked(THICKNESS, p_thickness, label());
	forget();
}

void GrassBoneColliders3D::set_length_min(double p_length) {
	_length_min = checked(LENGTH_MIN, p_length, label());
	forget();
}

PackedStringArray GrassBoneColliders3D::_get_configuration_warnings() const {
	PackedStringArray warnings;
	const Skeleton3D *skeleton = find_skeleton();
	if (is_inside_tree() && skeleton == nullptr) {
		warnings.push_back("No skeleton: make this node a child of a Skeleton3D, or set `skeleton`.");
	}
	for (int64_t i = 0; skeleton != nullptr && i < _bones.size(); i++) {
		if (skeleton->find_bone(_bones[i]) < 0) {
			warnings.push_back(vformat("The skeleton has no bone '%s'. Correct its name in `bones`.", _bones[i]));
		}
	}
	return warnings;
}

void GrassBoneColliders3D::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_WORLD:
			_world = get_world_3d();
			skeletons_in_tree.emplace(get_instance_id(), this);
			update_configuration_warnings();
			break;
		case NOTIFICATION_EXIT_WORLD:
			skeletons_in_tree.erase(get_instance_id());
			_world.unref();
			forget();
			break;
	}
}

void GrassBoneColliders3D::_bind_methods() {
	GRASS_BIND_PROPERTY(GrassBoneColliders3D, PropertyInfo(Variant::BOOL, "enabled"), set_enabled, is_enabled);
	GRASS_BIND_PROPERTY(GrassBoneColliders3D,
			PropertyInfo(Variant::NODE_PATH, "skeleton", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Skeleton3D"), set_skeleton, get_skeleton);
	GRASS_BIND_PROPERTY(GrassBoneColliders3D, PropertyInfo(Variant::PACKED_STRING_ARRAY, "bones"), set_bones, get_bones);
	GRASS_BIND_PROPERTY(GrassBoneColliders3D, property_of(THICKNESS), set_thickness, get_thickness);
	GRASS_BIND_PROPERTY(GrassBoneColliders3D, property_of(LENGTH_MIN), set_length_min, get_length_min);
}

} // namespace grass
