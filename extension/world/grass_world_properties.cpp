// SPDX-License-Identifier: MIT
// GrassWorld's properties, and the methods that scripts may call.
#include "world/grass_world.h"

#include "shared/bind_property.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/script_call.h"

#include <cmath>

using namespace godot;

namespace grass {

void GrassWorld::set_size(const Vector2 &p_size) {
	GRASS_MAIN_THREAD_ONLY();
	const Vector2 size(real_t(checked(WorldGrid::SIZE, p_size.x, label())), real_t(checked(WorldGrid::SIZE, p_size.y, label())));
	if (replace(_properties.size, size)) {
		restart();
	}
}

void GrassWorld::set_plot_size(double p_size) {
	GRASS_MAIN_THREAD_ONLY();
	const double size = checked(WorldGrid::PLOT_SIZE, p_size, label());
	const double whole = std::round(size / MAP_CHUNK_SIZE) * MAP_CHUNK_SIZE;
	if (whole != size) {
		WARN_PRINT(vformat("%s: `plot_size` must be whole chunks of 64 m; using %d instead of %s.", label(), int64_t(whole), size));
	}
	if (replace(_properties.plot_size, whole) && outlives(*this, [&] { restart(); })) {
		ask_about_kept();
	}
}

void GrassWorld::set_plot_scene(const Ref<PackedScene> &p_scene) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.scene, p_scene)) {
		restart();
	}
}

void GrassWorld::set_camera_radius(double p_radius) {
	GRASS_MAIN_THREAD_ONLY();
	_properties.camera_radius = checked(WORLD_CAMERA_RADIUS, p_radius, label());
}

void GrassWorld::set_body_radius(double p_radius) {
	GRASS_MAIN_THREAD_ONLY();
	_properties.body_radius = checked(WORLD_BODY_RADIUS, p_radius, label());
}

void GrassWorld::set_memory_budget(double p_megabytes) {
	GRASS_MAIN_THREAD_ONLY();
	_properties.memory_budget = checked(WORLD_MEMORY_BUDGET, p_megabytes, label());
	_plots.set_budget(_properties.budget());
}

void GrassWorld::set_folder(const String &p_folder) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.folder, p_folder) && outlives(*this, [&] { restart(); })) {
		ask_about_kept();
	}
}

void GrassWorld::set_save_folder(const String &p_folder) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_properties.save_folder, p_folder)) {
		restart();
	}
}

// Runs after a folder or the plots' size has changed.
void GrassWorld::ask_about_kept() {
	if (places_changed != nullptr && WorldProperties::is_edited() && count_kept_elsewhere() > 0) {
		places_changed(*this);
	}
}

void GrassWorld::_bind_methods() {
	constexpr PartBinder<GrassWorld, &GrassWorld::_work> work;
	GRASS_BIND_PROPERTY(GrassWorld, PropertyInfo(Variant::VECTOR2, "size", PROPERTY_HINT_NONE, "suffix:m"), set_size, get_size);
	GRASS_BIND_PROPERTY(GrassWorld, property_of(WorldGrid::PLOT_SIZE), set_plot_size, get_plot_size);
	GRASS_BIND_PROPERTY(GrassWorld, PropertyInfo(Variant::OBJECT, "plot_scene", PROPERTY_HINT_RESOURCE_TYPE, "PackedScene"), set_plot_scene,
			get_plot_scene);
	GRASS_BIND_PROPERTY(GrassWorld, property_of(WORLD_CAMERA_RADIUS), set_camera_radius, get_camera_radius);
	GRASS_BIND_PROPERTY(GrassWorld, property_of(WORLD_BODY_RADIUS), set_body_radius, get_body_radius);
	GRASS_BIND_PROPERTY(GrassWorld, property_of(WORLD_MEMORY_BUDGET), set_memory_budget, get_memory_budget);
	GRASS_BIND_PROPERTY(GrassWorld, PropertyInfo(Variant::STRING, "folder", PROPERTY_HINT_DIR), set_folder, get_folder);
	GRASS_BIND_PROPERTY(GrassWorld, PropertyInfo(Variant::STRING, "save_folder"), set_save_folder, get_save_folder);
	ClassDB::bind_method(D_METHOD("get_plot_at", "global_position"), &GrassWorld::get_plot_at);
	ClassDB::bind_method(D_METHOD("get_plot_path", "plot"), &GrassWorld::get_plot_path);
	ClassDB::bind_method(D_METHOD("get_field", "plot"), &GrassWorld::get_field);
	ClassDB::bind_method(D_METHOD("get_field_at", "global_position"), &GrassWorld::get_field_at);
	ClassDB::bind_method(D_METHOD("get_fields"), &GrassWorld::get_fields);
	work.bind<"cut", &WorldWork::cut>({ "shape", "transform" });
	work.bind<"paint", &WorldWork::paint>({ "brush", "from", "to" });
	ClassDB::bind_method(D_METHOD("shift_origin", "offset"), &GrassWorld::shift_origin);
	ClassDB::bind_method(D_METHOD("save"), &GrassWorld::save);
	ClassDB::bind_method(D_METHOD("carry_unsaved"), &GrassWorld::carry_unsaved);
	ClassDB::bind_method(D_METHOD("discard_unsaved"), &GrassWorld::discard_unsaved);
	ClassDB::bind_method(D_METHOD("wait_for_files"), &GrassWorld::wait_for_files);
	ClassDB::bind_method(D_METHOD("restore_plot", "plot", "snapshot", "from"), &GrassWorld::restore_plot);
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassWorld::get_statistics);
	const PropertyInfo plot(Variant::VECTOR2I, "plot"), field(Variant::OBJECT, "field", PROPERTY_HINT_RESOURCE_TYPE, "GrassField");
	ADD_SIGNAL(MethodInfo("plot_loaded", plot, field));
	ADD_SIGNAL(MethodInfo("plot_leaving", plot, field));
}

} // namespace grass
