// SPDX-License-Identifier: MIT
// The extension's table of contents: what it registers, at which level, and where the engine enters.
#include "register_types.h"

#include "draw/growing_arrays.h"
#include "draw/patch_texture.h"
#include "draw/shared_shader.h"
#include "editor/register_editor.h"
#include "field/project_pool.h"
#include "gpu/render_queue.h"
#include "nodes/field_monitors.h"
#include "nodes/field_turns.h"
#include "nodes/grass_field.h"
#include "resources/grass_bone_colliders_3d.h"
#include "resources/grass_brush.h"
#include "resources/grass_exclusion_3d.h"
#include "resources/grass_fill_rule.h"
#include "resources/grass_force_3d.h"
#include "resources/grass_map.h"
#include "resources/grass_map_file.h"
#include "resources/grass_patch.h"
#include "resources/grass_path_3d.h"
#include "resources/grass_quality.h"
#include "resources/grass_species.h"
#include "resources/size_limits.h"
#include "shared/keep_loaded.h"
#include "shared/parallel.h"
#include "shared/scene_watch.h"
#include "shared/shared_area.h"
#include "world/grass_world.h"

#include <gdextension_interface.h>
#include <godot_cpp/godot.hpp>

using namespace godot;

void initialize_grass_field(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_INTERNAL_CLASS(grass::RenderQueue);
		GDREGISTER_INTERNAL_CLASS(grass::SceneWatch);
		GDREGISTER_INTERNAL_CLASS(grass::SharedArea);
		GDREGISTER_INTERNAL_CLASS(grass::FieldMonitors);
		GDREGISTER_INTERNAL_CLASS(grass::FieldTurns);
		GDREGISTER_INTERNAL_CLASS(grass::GrassMapLoader);
		GDREGISTER_INTERNAL_CLASS(grass::GrassMapSaver);
		GDREGISTER_CLASS(grass::GrassPatch);
		GDREGISTER_CLASS(grass::GrassSpecies);
		GDREGISTER_CLASS(grass::GrassBrush);
		GDREGISTER_CLASS(grass::GrassQuality);
		GDREGISTER_CLASS(grass::GrassMapSnapshot);
		GDREGISTER_CLASS(grass::GrassFillRule);
		GDREGISTER_CLASS(grass::GrassMap);
		GDREGISTER_CLASS(grass::GrassExclusion3D);
		GDREGISTER_CLASS(grass::GrassPath3D);
		GDREGISTER_CLASS(grass::GrassForce3D);
		GDREGISTER_CLASS(grass::GrassBoneColliders3D);
		GDREGISTER_CLASS(grass::GrassField);
		GDREGISTER_CLASS(grass::GrassWorld);
		grass::register_size_limits();
		grass::register_project_pool();
		grass::register_quality();
		grass::register_map_files();
	}
#ifndef GRASS_WITHOUT_EDITOR
	if (p_level == MODULE_INITIALIZATION_LEVEL_EDITOR) {
		grass::register_editor();
	}
#endif
}

void uninitialize_grass_field(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		grass::finish_parallel();
		grass::unregister_map_files();
		grass::FieldMonitors::free_singleton();
		grass::FieldTurns::free_singleton();
		grass::GrassPatch::free_default();
		grass::free_quality();
		grass::finish_growing_arrays();
		grass::free_shared_textures();
		grass::free_shared_shaders();
		grass::RenderQueue::free_singleton();
		grass::SceneWatch::free_singleton();
	}
}

extern "C" GDExtensionBool GDE_EXPORT grass_field_library_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	grass::keep_library_loaded();
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize_grass_field);
	init.register_terminator(uninitialize_grass_field);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
