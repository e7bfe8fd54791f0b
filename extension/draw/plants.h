// SPDX-License-Identifier: MIT
// Draws a field's plants: for each species with a mesh, and for its impostor, a MultiMesh, whose instances a backend writes, and materials.
#pragma once

#include "core/lod/field_levels.h"
#include "draw/drawn_plant.h"
#include "draw/field_instance.h"
#include "draw/shared_shader.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace grass {

class Plants {
public:
	struct Plant {
		int species, stage; // GRASS_PLANT_MESH or GRASS_PLANT_IMPOSTOR
		DrawnPlant drawn;
		FieldInstance instance;
		std::vector<godot::Ref<godot::ShaderMaterial>> materials; // of the mesh's surfaces
		int number() const { return species + GRASS_MAX_SPECIES * stage; } // among all of a field, as PlantCull::Kinds
	};

	// Most plants of one species drawn at once.
	static constexpr int ROOM = 65536;

	static ShaderText text(const Look &p_look, int p_stage); // of its shader
	// Sets the look of later plants, and of these if they fit it: with another hook.
	void set_look(const Look &p_look);
	// Sets the plants. p_plants: by species. p_room: how many plants the MultiMesh must hold up to a distance, metres. Uniforms must be set
	// again afterwards.
	void set(const std::vector<DrawnPlant> &p_plants, const std::function<int(float p_distance)> &p_room, bool p_indirect,
			const godot::AABB &p_bounds);
	// Sets a uniform of the materials. A shader ignores a uniform that it does not have.
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value);
	void set_bounds(const godot::AABB &p_bounds);
	// Draws no plants that no camera is near enough to see. p_ground: see find_levels().
	void fit(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground);
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_is_flipped = false);

	bool is_empty() const { return _plants.empty(); }
	const std::vector<std::unique_ptr<Plant>> &get() const { return _plants; }
	int64_t get_updates() const; // changes of the node that were passed to the renderer
	int64_t get_memory_usage() const; // bytes

private:
	void add(const DrawnPlant &p_drawn, int p_species, int p_stage, int p_room, bool p_indirect, const godot::AABB &p_bounds);

	Look _look;
	std::vector<std::unique_ptr<Plant>> _plants;
};

} // namespace grass
