// SPDX-License-Identifier: MIT
#include "editor/map_step.h"

#include "editor/field_stroke.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/undo_redo.hpp>

#include <vector>

using namespace godot;

namespace grass {

void add_map_steps(EditorUndoRedoManager *p_history, const String &p_name, Object *p_context, std::span<const MapStep> p_steps) {
	p_history->create_action(p_name, UndoRedo::MERGE_DISABLE, p_context);
	for (const MapStep &step : p_steps) {
		if (step.new_of != nullptr) {
			p_history->add_do_property(step.new_of, "map", step.map);
			p_history->add_undo_property(step.new_of, "map", Variant());
		}
		GrassMap *map = step.map.ptr();
		const Ref<GrassMapSnapshot> after = map->take_snapshot();
		if (step.world != nullptr) {
			p_history->add_do_method(step.world, "restore_plot", step.plot, after, step.before);
			p_history->add_undo_method(step.world, "restore_plot", step.plot, step.before, after);
			continue;
		}
		// Another scene with the same file may have painted it meanwhile.
		p_history->add_do_method(map, "restore_snapshot", after, step.before);
		p_history->add_undo_method(map, "restore_snapshot", step.before, after);
	}
	p_history->commit_action(false);
	for (const MapStep &step : p_steps) {
		if (step.world == nullptr) { // a world saves its plots itself
			EditorInterface::get_singleton()->set_object_edited(const_cast<GrassMap *>(step.map.ptr()), true);
		}
	}
}

void change_maps(EditorUndoRedoManager *p_history, const String &p_name, std::span<GrassField *const> p_fields, GrassWorld *p_world,
		bool p_follows, const MapChange &p_change) {
	std::vector<MapStep> steps;
	for (GrassField *field : p_fields) {
		const bool is_new = field->get_map().is_null();
		const Ref<GrassMap> map = is_new ? add_map(field, p_follows) : field->get_map();
		const Ref<GrassMapSnapshot> before = map->take_snapshot();
		if (p_change(*field, **map)) {
			const Vector2i plot = p_world != nullptr ? p_world->get_plot_at(field->get_global_position()) : Vector2i();
			steps.push_back({ map, before, is_new ? field : nullptr, p_world, plot });
		} else if (is_new) {
			field->set_map(Ref<GrassMap>());
		}
	}
	if (!steps.empty()) {
		add_map_steps(p_history, p_name, p_world != nullptr ? static_cast<Object *>(p_world) : p_fields[0], steps);
	}
}

} // namespace grass
