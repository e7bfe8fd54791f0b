// SPDX-License-Identifier: MIT
// The node's life and its frames.
#include "world/grass_world.h"

#include "core/base/cpu_clock.h"
#include "draw/frame_share.h"
#include "resources/grass_force_3d.h"
#include "shared/main_thread.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassWorld::_notification(int p_what) {
	switch (p_what) {
		case NOTIFICATION_ENTER_WORLD:
			enter();
			break;
		case NOTIFICATION_EXIT_WORLD:
			leave();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			if (is_main_thread()) {
				callable_mp(this, &GrassWorld::_frame).call_deferred();
			}
			break;
		case NOTIFICATION_INTERNAL_PHYSICS_PROCESS:
			if (is_main_thread()) {
				_eyes.tick(world_transform(), Vector3(0.5f * _properties.size.x, 4096, 0.5f * _properties.size.y));
			}
			break;
		case NOTIFICATION_PREDELETE:
			_plots.stop();
			_report.print_loss();
			break;
		case NOTIFICATION_EDITOR_POST_SAVE: // after its scene was saved, visible or not
			if (scene_saved != nullptr) {
				scene_saved(*this);
			}
			break;
	}
}

void GrassWorld::enter() {
	FrameShare::spare(true);
	restart();
	set_process_internal(true);
	set_physics_process_internal(true);
}

void GrassWorld::leave() {
	set_process_internal(false);
	set_physics_process_internal(false);
	_eyes.stop();
	_plots.stop();
	FrameShare::spare(false);
}

// Runs when the world enters the tree, and when a property changes. Writes changes of the plots first.
void GrassWorld::restart() {
	if (!is_inside_tree()) {
		return;
	}
	const bool lives = outlives(*this, [&] {
		_plots.start({ _properties.grid(), _properties.scene, _properties.budget() }, find_folders());
	});
	if (!lives || !is_inside_tree()) { // scripts of `plot_scene` have run
		return;
	}
	_report.restart();
	if (!WorldProperties::is_edited()) {
		_eyes.start(get_world_3d()->get_space(), callable_mp(this, &GrassWorld::_body_changed),
				_plots.get_fields().get_pattern().collision_mask);
	}
	update_configuration_warnings();
}

// Returns the folders. The editor writes only when the scene is saved. Without a folder nothing can be written.
WorldFolders GrassWorld::find_folders() const {
	const PlotsPlace place = _properties.place();
	return { place, label(), place.to.is_empty() || WorldProperties::is_edited() };
}

void GrassWorld::_frame() {
	if (!is_inside_tree()) {
		return;
	}
	CpuClock clock;
	std::vector<WorldEye> eyes;
	for (const Eigen::Vector2d &camera : _eyes.find_cameras(*this, _plots.find_layers())) {
		eyes.push_back({ camera, _properties.camera_radius });
	}
	for (const Eigen::Vector2d &body : _eyes.find_bodies()) {
		eyes.push_back({ body, _properties.body_radius });
	}
	if (!outlives(*this, [&] { _plots.update(eyes); }) || !is_inside_tree()) {
		return;
	}
	_report.print_warnings();
	_report.count_frame(clock.lap());
}

void GrassWorld::tell(const char *p_signal, const PlotKey &p_key, GrassField *p_field) {
	emit_signal(p_signal, Vector2i(p_key.x, p_key.z), p_field);
}

void GrassWorld::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t, int64_t) {
	_eyes.body_changed(p_status, p_body, p_instance_id);
}

} // namespace grass
