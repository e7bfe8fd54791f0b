// SPDX-License-Identifier: MIT
#include "draw/plants.h"

#include "core/base/layout.h"
#include "render_shaders.gen.h"

#include <utility>

using namespace godot;

namespace grass {

namespace {

std::vector<Ref<ShaderMaterial>> make_materials(const PlantModel &p_model, const Look &p_look) {
	std::vector<Ref<ShaderMaterial>> materials;
	for (const PlantModel::Surface &surface : p_model.surfaces) {
		Ref<ShaderMaterial> &material = materials.emplace_back();
		material.instantiate();
		material->set_shader(shared_shader(Plants::text(p_look, GRASS_PLANT_MESH)));
		material->set_shader_parameter("plant_color", surface.color);
		material->set_shader_parameter("plant_scissor", surface.scissor);
		if (surface.texture.is_valid()) {
			material->set_shader_parameter("plant_texture", surface.texture);
		}
	}
	return materials;
}

std::vector<Ref<ShaderMaterial>> make_materials(const PlantImpostor &p_impostor, const Look &p_look) {
	Ref<ShaderMaterial> material;
	material.instantiate();
	material->set_shader(shared_shader(Plants::text(p_look, GRASS_PLANT_IMPOSTOR)));
	material->set_shader_parameter("impostor_colors", p_impostor.get_pictures().colors);
	material->set_shader_parameter("impostor_normals", p_impostor.get_pictures().normals);
	return { material };
}

} // namespace

ShaderText Plants::text(const Look &p_look, int p_stage) {
	const int ledges = p_look.features & SHADER_MAP ? SHADER_LEDGES : 0; // one shader for maps with ledges and without
	const int impostor = p_stage == GRASS_PLANT_IMPOSTOR ? SHADER_IMPOSTOR : 0;
	const int features = (p_look.features & (SHADER_MAP | SHADER_SPECIES)) | ledges | impostor;
	return { shader::PLANT_GDSHADER, VertexKind::PLANT, { features, p_look.hook } };
}

void Plants::set_look(const Look &p_look) {
	const Look before = std::exchange(_look, p_look);
	for (const auto &plant : _plants) {
		const ShaderText now = text(p_look, plant->stage);
		if (now.look.features != text(before, plant->stage).look.features) {
			continue; // of another field, whose plants will come: set()
		}
		for (const Ref<ShaderMaterial> &material : plant->materials) {
			material->set_shader(shared_shader(now));
		}
	}
}

void Plants::set(const std::vector<DrawnPlant> &p_plants, const std::function<int(float)> &p_room, bool p_indirect, const AABB &p_bounds) {
	_plants.clear();
	for (size_t species = 0; species < p_plants.size(); species++) {
		const DrawnPlant &drawn = p_plants[species];
		for (int stage = 0; stage < GRASS_PLANT_STAGES; stage++) {
			if (drawn.has(stage)) {
				add(drawn, int(species), stage, p_room(drawn.kind(stage, 1.0f, 1.0).distance), p_indirect, p_bounds);
			}
		}
	}
}

void Plants::add(const DrawnPlant &p_drawn, int p_species, int p_stage, int p_room, bool p_indirect, const AABB &p_bounds) {
	Plant &plant = *_plants.emplace_back(std::make_unique<Plant>());
	plant.species = p_species;
	plant.stage = p_stage;
	plant.drawn = p_drawn;
	const bool is_mesh = p_stage == GRASS_PLANT_MESH;
	plant.materials = is_mesh ? make_materials(*p_drawn.model, _look) : make_materials(*p_drawn.impostor, _look);
	const Ref<ArrayMesh> mesh = is_mesh ? make_plant_mesh(*p_drawn.model) : make_impostor_mesh(*p_drawn.impostor);
	for (size_t s = 0; s < plant.materials.size(); s++) {
		plant.materials[s]->set_shader_parameter("plant_species", p_species);
		mesh->surface_set_material(int32_t(s), plant.materials[s]);
	}
	plant.instance.create(std::make_shared<const Ref<ArrayMesh>>(mesh), Ref<ShaderMaterial>(), p_room,
			p_indirect ? Written::BY_GPU : Written::BY_CPU, p_bounds, Role::BOTH);
}

void Plants::set_uniform(const StringName &p_name, const Variant &p_value) {
	for (const auto &plant : _plants) {
		for (const Ref<ShaderMaterial> &material : plant->materials) {
			material->set_shader_parameter(p_name, p_value);
		}
	}
}

void Plants::set_bounds(const AABB &p_bounds) {
	for (const auto &plant : _plants) {
		plant->instance.set_bounds(p_bounds);
	}
}

void Plants::fit(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground) {
	for (const auto &plant : _plants) {
		plant->instance.need(is_within(p_field, p_view, p_ground, plant->drawn.kind(plant->stage, p_view.plant_reach, 1.0).distance));
	}
}

void Plants::follow(GeometryInstance3D *p_node, const Transform3D &p_transform, bool p_is_flipped) {
	for (const auto &plant : _plants) {
		plant->instance.follow(p_node, p_transform, p_is_flipped);
	}
}

int64_t Plants::get_updates() const {
	int64_t updates = 0;
	for (const auto &plant : _plants) {
		updates += plant->instance.get_updates();
	}
	return updates;
}

int64_t Plants::get_memory_usage() const {
	int64_t bytes = 0;
	for (const auto &plant : _plants) {
		const DrawnPlant &drawn = plant->drawn;
		bytes += plant->stage == GRASS_PLANT_MESH ? drawn.model->get_memory_usage() : drawn.impostor->get_memory_usage();
		bytes += int64_t(plant->instance.capacity()) * GRASS_INSTANCE_FLOATS * 4;
	}
	return bytes;
}

} // namespace grass
