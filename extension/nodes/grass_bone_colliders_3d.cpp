// SPDX-License-Identifier: MIT
#include "nodes/grass_bone_colliders_3d.h"

#include "nodes/bind_property.h"
#include "nodes/params.h"

#include <algorithm>
#include <set>

using namespace godot;

namespace grass {

namespace {

// Nodes enter and leave on the main thread.
std::set<GrassBoneColliders3D *> skeletons_in_tree;

} // namespace

std::vector<const GrassBoneColliders3D *> GrassBoneColliders3D::get_all() {
	std::vector<const GrassBoneColliders3D *> all;
	for (const GrassBoneColliders3D *node : skeletons_in_tree) {
		if (node->_enabled) {
			all.push_back(node);
		}
	}
	std::ranges::sort(all, {}, [](const GrassBoneColliders3D *p_node) { return p_node->get_instance_id(); });
	return all;
}

// The one that `skeleton` names; without a name the parent.
const Skeleton3D *GrassBoneColliders3D::find_skeleton() const {
	if (!is_inside_tree()) {
		return nullptr;
	}
	return Object::cast_to<Skeleton3D>(_skeleton.is_empty() ? get_parent() : get_node_or_null(_skeleton));
}

std::vector<GrassBoneColliders3D::Bone> GrassBoneColliders3D::find_bones() const {
	std::vector<Bone> bones;
	const Skeleton3D *skeleton = find_skeleton();
	if (skeleton == nullptr || !skeleton->is_inside_tree()) {
		return bones;
	}
	const Transform3D to_world = skeleton->get_global_transform();
	for (int i = 0; i < skeleton->get_bone_count(); i++) {
		const int parent = skeleton->get_bone_parent(i);
		if (parent < 0 || (!_bones.is_empty() && !_bones.has(skeleton->get_bone_name(parent)))) {
			continue;
		}
		Bone bone;
		bone.index = i;
		bone.from = to_world.xform(skeleton->get_bone_global_pose(parent).origin);
		bone.to = to_world.xform(skeleton->get_bone_global_pose(i).origin);
		const double length = (bone.to - bone.from).length();
		bone.radius = _thickness * length;
		if (length >= _length_min && length > 0.0) {
			bones.push_back(bone);
		}
	}
	return bones;
}

void GrassBoneColliders3D::set_skeleton(const NodePath &p_skeleton) {
	if (replace(_skeleton, p_skeleton)) {
		update_configuration_warnings();
	}
}

void GrassBoneColliders3D::set_bones(const PackedStringArray &p_bones) {
	if (replace(_bones, p_bones)) {
		update_configuration_warnings();
	}
}

void GrassBoneColliders3D::set_thickness(double p_thickness) {
	_thickness = checked(THICKNESS, p_thickness, label());
}

void GrassBoneColliders3D::set_length_min(double p_length) {
	_length_min = checked(LENGTH_MIN, p_length, label());
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
			skeletons_in_tree.insert(this);
			update_configuration_warnings();
			break;
		case NOTIFICATION_EXIT_WORLD:
			skeletons_in_tree.erase(this);
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
