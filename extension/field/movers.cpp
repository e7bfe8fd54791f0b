// SPDX-License-Identifier: MIT
#include "field/movers.h"

#include "resources/grass_bone_colliders_3d.h"
#include "resources/grass_force_3d.h"
#include "shared/convert.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns the id of a world; 0, the id of none, for a node that is in none.
uint64_t id_of(const Ref<World3D> &p_world) {
	return p_world.is_valid() ? p_world->get_instance_id() : 0;
}

} // namespace

std::vector<Mover> Movers::find(BodyReads &r_reads) {
	std::vector<Mover> movers;
	for (GrassForce3D *force : GrassForce3D::is_any_in_tree() ? GrassForce3D::get_blowing() : std::vector<GrassForce3D *>()) {
		const Eigen::Vector3d place = to_eigen(force->get_global_position()), reach = Eigen::Vector3d::Constant(force->get_radius());
		movers.push_back({ id_of(force->get_world_3d()), { Eigen::Vector3d(place - reach), Eigen::Vector3d(place + reach) } });
	}
	for (const SoftBody3D *body : SceneWatch::get_singleton()->get_soft_bodies()) {
		movers.push_back({ id_of(body->get_world_3d()), _soft_bodies.find_box(body) });
	}
	for (const auto &[id, skeleton] : GrassBoneColliders3D::get_all()) {
		movers.push_back({ id_of(skeleton->get_world()), skeleton->find_bounds(r_reads.engine_calls) });
	}
	std::erase_if(movers, [](const Mover &p_mover) { return p_mover.box.isEmpty(); });
	return movers;
}

} // namespace grass
