// SPDX-License-Identifier: MIT
// Gathers a fill rule's sources from the scene: exclusion nodes, and the nodes of the groups that the rule names. A source that did not
// change is the same object as last time, so that only what changed is filled again.
#pragma once

#include "physics/body_tracker.h"
#include "resources/grass_fill_rule.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>

namespace grass {

class FillGatherer {
public:
	// p_node: the field, in the tree; p_field: its transform (orthonormal).
	FillSources gather(const GrassFillRule &p_rule, const godot::Node3D *p_node, const godot::Transform3D &p_field);
	// Returns the id of the node from which an obstacle of the last gathering was made; 0: none.
	uint64_t get_node_of(const FillObstacle *p_obstacle) const;

private:
	// The data from which an obstacle was made.
	struct Source {
		Eigen::Matrix4d pose = Eigen::Matrix4d::Zero(); // from the node's space into the field's
		godot::Variant data; // of the shape, the outline or the curve
		std::array<double, 3> numbers{}; // distance, fade, height; metres. For a path: half its width, fade, mode
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
	std::shared_ptr<const FillMesh> find_mesh(const godot::StringName &p_group);
	Eigen::Affine3d pose_of(const godot::Node3D *p_node) const;
	// Returns the nodes of a group in the field's world.
	std::vector<godot::Node3D *> find_nodes(const godot::StringName &p_group) const;

	const godot::Node3D *_field = nullptr; // while gathering
	Eigen::Affine3d _field_from_world;
	FillSources _sources;
	std::map<uint64_t, Entry> _entries; // by the node's instance id
	std::vector<std::pair<uint64_t, Eigen::Matrix4d>> _mesh_of; // the meshes in _mesh and their poses, by the mesh's instance id
	std::shared_ptr<const FillMesh> _mesh;
};

} // namespace grass
