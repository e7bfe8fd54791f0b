// SPDX-License-Identifier: MIT
#include "draw/node_follower.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/world3d.hpp>

using namespace godot;

namespace grass {

void NodeFollower::follow(const RID &p_instance, GeometryInstance3D *p_node, const Transform3D &p_transform, bool p_is_wanted) {
	const bool in_world = p_node->is_inside_tree() && p_node->get_world_3d().is_valid();
	State now;
	now.scenario = in_world ? p_node->get_world_3d()->get_scenario() : RID();
	now.transform = p_transform;
	_is_node_visible = in_world && p_node->is_visible_in_tree();
	now.is_visible = p_is_wanted && _is_node_visible;
	now.layers = p_node->get_layer_mask();
	now.transparency = p_node->get_transparency();
	now.takes_probes = p_node->get_gi_mode() == GeometryInstance3D::GI_MODE_DYNAMIC;
	now.node_id = p_node->get_instance_id();
	if (_is_known && now == _told) {
		return;
	}
	RenderingServer *server = RenderingServer::get_singleton();
	if (!_is_known || now.scenario != _told.scenario) {
		server->instance_set_scenario(p_instance, now.scenario);
	}
	server->instance_set_transform(p_instance, now.transform);
	server->instance_set_visible(p_instance, now.is_visible);
	server->instance_set_layer_mask(p_instance, now.layers);
	server->instance_geometry_set_transparency(p_instance, float(now.transparency));
	server->instance_geometry_set_flag(p_instance, RenderingServer::INSTANCE_FLAG_USE_DYNAMIC_GI, now.takes_probes);
	server->instance_attach_object_instance_id(p_instance, now.node_id);
	_told = now;
	_is_known = true;
	_updates++;
}

void NodeFollower::show(const RID &p_instance, bool p_is_wanted) {
	const bool is_visible = p_is_wanted && _is_node_visible;
	if (_is_known && _told.is_visible != is_visible) {
		RenderingServer::get_singleton()->instance_set_visible(p_instance, is_visible);
		_told.is_visible = is_visible;
	}
}

} // namespace grass
