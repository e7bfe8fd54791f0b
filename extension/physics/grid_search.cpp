// SPDX-License-Identifier: MIT
#include "physics/grid_search.h"

#include "physics/ground_triangles.h"
#include "shared/convert.h"

#include <godot_cpp/classes/physics_server3d.hpp>

#include <set>
#include <utility>

using namespace godot;

namespace grass {

namespace {

constexpr int PROBES = 8; // along a side. More: smaller terrains are found

} // namespace

GroundGrid search_grid(GroundRays &r_rays, const MapRegion &p_region, const Transform3D &p_field) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Eigen::Affine3d to_field = to_eigen(p_field).inverse(Eigen::Isometry);
	std::set<std::pair<uint64_t, int64_t>> seen; // bodies and shapes
	GroundGrid found;
	int64_t most = 0; // triangles
	for (int n = 0; n < PROBES * PROBES; n++) {
		const Eigen::Array2d share = (Eigen::Array2d(n % PROBES, n / PROBES) + 0.5) / PROBES;
		const auto hit = r_rays.hit_at(p_region.min.array() + share * (p_region.max - p_region.min).array());
		if (!hit || !seen.emplace(hit->body.get_id(), hit->shape).second) {
			continue;
		}
		const Transform3D body = server->body_get_state(hit->body, PhysicsServer3D::BODY_STATE_TRANSFORM);
		const int32_t shape = int32_t(hit->shape);
		const GroundTriangles ground(server->body_get_shape(hit->body, shape));
		if (ground.count() <= most) {
			continue;
		}
		const Transform3D to_world = body * server->body_get_shape_transform(hit->body, shape);
		if (const auto grid = ground.find_grid(to_field * to_eigen(to_world))) {
			most = ground.count();
			found = *grid;
		}
	}
	return found;
}

} // namespace grass
