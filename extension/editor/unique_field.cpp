// SPDX-License-Identifier: MIT
#include "editor/unique_field.h"

#include "editor/field_owner.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_undo_redo_manager.hpp>

using namespace godot;

namespace grass {

namespace {

// A step of the undo history that sets properties of a field.
class PropertyStep {
public:
	PropertyStep(const String &p_name, GrassField &r_field) :
			_history(EditorInterface::get_singleton()->get_editor_undo_redo()), _field(&r_field) {
		_history->create_action(p_name, UndoRedo::MERGE_DISABLE, _field);
	}
	void set(const StringName &p_property, const Variant &p_value) {
		_history->add_do_property(_field, p_property, p_value);
		_history->add_undo_property(_field, p_property, _field->get(p_property));
	}
	~PropertyStep() { _history->commit_action(); }

private:
	EditorUndoRedoManager *_history;
	GrassField *_field;
};

// Files, such as presets, stay shared.
Ref<Resource> own_if_inside(const Ref<Resource> &p_resource) {
	return p_resource.is_null() || has_own_file(**p_resource) ? p_resource : own_copy(p_resource);
}

} // namespace

void make_map_unique(GrassField &r_field) {
	PropertyStep("Make Grass Map Unique", r_field).set("map", own_copy(r_field.get_map()));
}

void make_unique(GrassField &r_field) {
	TypedArray<GrassSpecies> species = r_field.get_species().duplicate();
	for (int64_t i = 0; i < species.size(); i++) {
		species[i] = own_if_inside(species[i]);
	}
	PropertyStep step("Make Grass Field Unique", r_field);
	step.set("map", own_copy(r_field.get_map()));
	step.set("fill_rule", own_if_inside(r_field.get_fill_rule()));
	step.set("species", species);
}

} // namespace grass
