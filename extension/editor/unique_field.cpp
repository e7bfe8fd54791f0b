// SPDX-License-Identifier: MIT
#include "editor/unique_field.h"

#include "editor/field_owner.h"
#include "editor/toast.h"
#include "nodes/field_monitors.h"

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

String names_of(const std::vector<const GrassField *> &p_fields) {
	PackedStringArray names;
	for (const GrassField *field : p_fields) {
		names.push_back(field->get_name());
	}
	return String(", ").join(names);
}

// Parts a field from others that have its map, unless that is a file.
void part_from(GrassField &r_field, const std::vector<const GrassField *> &p_sharing) {
	const Ref<GrassMap> map = r_field.get_map();
	if (has_own_file(**map)) {
		toast(vformat("GrassField '%s': paint on it shows on %s as well, since both have the map %s. Choose Make Unique in the menu at the "
					  "toolbar's end to paint it apart.",
				r_field.get_name(), names_of(p_sharing), map->get_path().get_file()));
		return;
	}
	r_field.set_map(own_copy(map));
	toast(vformat("GrassField '%s' has a map of its own: paint on it leaves %s as it is.", r_field.get_name(), names_of(p_sharing)),
			EditorToaster::SEVERITY_INFO);
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

void tell_of_sharing(const GrassField &p_field) {
	if (const auto sharing = find_sharing(p_field); !sharing.empty()) {
		toast(vformat(
				"GrassField '%s': what is painted shows on %s as well, since they have the same map. Choose Make Unique in the menu at "
				"the toolbar's end to paint it apart.",
				p_field.get_name(), names_of(sharing)));
	}
}

void DuplicatedFields::update(const Node *p_root) {
	const uint64_t root_id = p_root != nullptr ? p_root->get_instance_id() : 0;
	const bool is_same_scene = root_id == _root_id;
	_root_id = root_id;
	std::erase_if(_known, [](uint64_t p_id) { return ObjectDB::get_instance(p_id) == nullptr; });
	std::vector<GrassField *> added;
	for (GrassField *field : FieldMonitors::get_fields()) {
		if (!_known.contains(field->get_instance_id())) {
			added.push_back(field);
		}
	}
	for (GrassField *field : added) {
		if (p_root == nullptr || !is_same_scene || !is_saved_by(*p_root, *field) ||
				!find_foreign_file(field->get_map(), *p_root).is_empty()) {
			continue; // it came with its scene
		}
		std::vector<const GrassField *> originals = find_sharing(*field);
		std::erase_if(originals, [&](const GrassField *p_other) { return !_known.contains(p_other->get_instance_id()); });
		if (!originals.empty()) {
			part_from(*field, originals);
		}
	}
	for (const GrassField *field : added) {
		_known.insert(field->get_instance_id());
	}
}

} // namespace grass
