// SPDX-License-Identifier: MIT
// The node's life and its frames.
#include "world/grass_world.h"

#include "core/base/cpu_clock.h"
#include "draw/frame_share.h"
#include "resources/grass_force_3d.h"
#include "shared/convert.h"
#include "shared/main_thread.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

String GrassWorld::label() const {
	return vformat("GrassWorld '%s'", is_inside_tree() ? String(get_path()) : String(get_name()));
}

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
				_eyes.tick(world_transform(), Vector3(0.5f * _size.x, 4096, 0.5f * _size.y));
			}
			break;
		case NOTIFICATION_PREDELETE:
			report_loss();
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
	const bool lives = outlives(*this, [&] { _plots.start({ grid(), _scene, to_bytes_of(_memory_budget) }, find_folders()); });
	if (!lives || !is_inside_tree()) { // scripts of `plot_scene` have run
		return;
	}
	_most_frame_ms = 0.0;
	_shortage = {};
	_has_reported = false;
	if (!Engine::get_singleton()->is_editor_hint()) {
		_eyes.start(get_world_3d()->get_space(), callable_mp(this, &GrassWorld::_body_changed),
				_plots.get_fields().get_pattern().collision_mask);
	}
	update_configuration_warnings();
}

// The editor shows what a level has, not what a game made of it, and writes only when the scene is saved. Without a folder nothing can be
// written.
WorldFolders GrassWorld::find_folders() const {
	const bool is_editor = Engine::get_singleton()->is_editor_hint();
	const String to = _save_folder.is_empty() || is_editor ? _folder : _save_folder;
	return { { _folder, to, _plot_size }, label(), to.is_empty() || is_editor };
}

void GrassWorld::_frame() {
	if (!is_inside_tree()) {
		return;
	}
	CpuClock clock;
	std::vector<WorldEye> eyes;
	for (const Eigen::Vector2d &camera : _eyes.find_cameras(*this, _plots.find_layers())) {
		eyes.push_back({ camera, _camera_radius });
	}
	for (const Eigen::Vector2d &body : _eyes.find_bodies()) {
		eyes.push_back({ body, _body_radius });
	}
	if (!outlives(*this, [&] { _plots.update(eyes); }) || !is_inside_tree()) {
		return;
	}
	report();
	_frame_ms = clock.lap();
	_most_frame_ms = std::max(_most_frame_ms, _frame_ms);
}

Transform3D GrassWorld::world_transform() const {
	const Transform3D transform = get_global_transform();
	const bool is_usable = transform.is_finite() && transform.basis.determinant() != 0.0;
	return is_usable ? transform.orthonormalized() : Transform3D(Basis(), transform.origin.is_finite() ? transform.origin : Vector3());
}

Eigen::Vector2d GrassWorld::place_of(const Vector3 &p_global_position) const {
	const Eigen::Vector3d place = to_eigen(world_transform()).inverse(Eigen::Isometry) * to_eigen(p_global_position);
	return { place.x(), place.z() };
}

void GrassWorld::tell(const char *p_signal, const PlotKey &p_key, GrassField *p_field) {
	emit_signal(p_signal, Vector2i(p_key.x, p_key.z), p_field);
}

void GrassWorld::_body_changed(int64_t p_status, const RID &p_body, int64_t p_instance_id, int64_t, int64_t) {
	_eyes.body_changed(p_status, p_body, p_instance_id);
}

} // namespace grass
