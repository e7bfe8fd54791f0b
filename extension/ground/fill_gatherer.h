// SPDX-License-Identifier: MIT
// Gathers a fill rule's sources from the scene: exclusion nodes, and the nodes of the groups that the rule names. A source that did not
// change is the same object as last time, so that only what changed is filled again.
#pragma once

#include "ground/mask_mesh.h"
#include "physics/body_tracker.h"
#include "resources/grass_fill_rule.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>

namespace grass {

class FillGatherer {
public:
	// Sets what the meshes of the mask group call when they change; it must call set_mesh_changed().
	void listen(const godot::Callable &p_mesh_changed) { _mask.listen(p_mesh_changed); }
	void set_mesh_changed() { _mask.set_changed(); }
	// Reads the meshes of the mask group. Must be called before gather(). p_node: the field, in the tree; p_field: its transform
	// (orthonormal). Meshes may be scripts: returns false if one of them freed the field, and this object with it.
	[[nodiscard]] bool read_meshes(const GrassFillRule &p_rule, const godot::Node3D *p_node, const godot::Transform3D &p_field);
	// Gathers the sources. Runs no script.
	FillSources gather(const GrassFillRule &p_rule, const godot::Node3D *p_node, const godot::Transform3D &p_field);
	// Returns the id of the node from which an obstacle of the last gathering was made; 0: none.
	uint64_t get_node_of(const FillObstacle *p_obstacle) const;

private:
	// The data from which an obstacle was made.
	struct Source {
		Eigen::Matrix4d pose = Eigen::Matrix4d::Zero(); // from the node's space into the field's
		godot::Variant data; // of the shape, the outline or the curve
		std::array<double, 3> numbers{}; // distance, fade, height; metres. For a path: half its width, fade, mode
		int64_t kind = -1; // PhysicsServer3D.ShapeType of a shape: a capsule's data may equal a cylinder's

		bool is_same(const Source &p_other) const;
	};
	struct Entry {
		Source source;
		std::shared_ptr<const FillObstacle> obstacle; // null: it excludes nothing
		bool is_seen = false;
	};

	void add_exclusions(const GrassFillRule &p_rule);
	void add_paths();
	void add_shapes(const GrassFillRule &p_rule, const godot::Node *p_node);
	void add_distances(const GrassFillRule &p_rule);
	void add_shape(const godot::Node3D *p_node, const godot::Ref<godot::Shape3D> &p_shape, double p_fade, double p_height);
	// Keeps the node's obstacle, or calls p_make to make a new one.
	template <typename F> void add(const godot::Node3D *p_node, const Source &p_source, F &&p_make);
	Eigen::Affine3d pose_of(const godot::Node3D *p_node) const;
	// Returns the nodes of a group in the field's world.
	std::vector<godot::Node3D *> find_nodes(const godot::StringName &p_group) const;

	const godot::Node3D *_field = nullptr; // while gathering
	Eigen::Affine3d _field_from_world;
	FillSources _sources;
	std::map<uint64_t, Entry> _entries; // by the node's instance id
	MaskMesh _mask;
};

} // namespace grass
