// SPDX-License-Identifier: MIT
// The meshes of a rule's mask group, as one mesh in the field's space. It is read again when the group, a place or a mesh has changed:
// meshes say so with their signal `changed`.
#pragma once

#include "core/fill/fill_mesh.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <memory>
#include <vector>

namespace grass {

class MaskMesh {
public:
	// A mesh of the group, and its pose in the field.
	struct Part {
		godot::Ref<godot::Mesh> mesh;
		Eigen::Affine3d pose;

		bool operator==(const Part &p_other) const { return mesh == p_other.mesh && pose.matrix() == p_other.pose.matrix(); }
	};
	using Parts = std::vector<Part>;

	// Sets what the meshes call when they change; it must call set_changed().
	void listen(const godot::Callable &p_changed);
	void set_changed() { _has_changed = true; }
	// Reads what has changed. Methods of a mesh may be scripts: returns false if one of them freed p_field, and this object with it. A
	// script that comes here again meanwhile finds the mesh as it was.
	[[nodiscard]] bool read(const godot::Node3D &p_field, Parts p_parts);
	// Returns the mesh that was read last; the same object while nothing has changed. Null: none.
	const std::shared_ptr<const FillMesh> &get() const { return _mesh; }

private:
	void watch(const Parts &p_parts);

	godot::Callable _changed; // null: nothing is called
	Parts _parts; // of _mesh
	std::vector<godot::Ref<godot::Mesh>> _watched; // connected to _changed
	std::shared_ptr<const FillMesh> _mesh;
	bool _has_changed = false; // one of the meshes has, since it was read
	bool _is_reading = false;
};

} // namespace grass
