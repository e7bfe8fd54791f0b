// SPDX-License-Identifier: MIT
// GrassField's fill rule: keeps the map filled by it, spread over frames, and only where something changed.
#include "nodes/grass_field.h"

#include "backend/parallel.h"
#include "nodes/grass_exclusion_3d.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_undo_redo_manager.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/undo_redo.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Filled in a frame, at most: 65,536 texels. More: frames stutter while a rule is changed. Fewer: a field of 1 km^2 (256 chunks) takes
// longer to follow.
constexpr int CHUNKS_A_FRAME = 4;
// Nodes of the rule's groups tell nobody when they move: they are looked at this often, frames.
constexpr int FRAMES_BETWEEN_LOOKS = 15;

void on_all_threads(int p_count, const std::function<void(int)> &p_body) {
	Parallel *parallel = memnew(Parallel);
	parallel->run(p_count, p_body);
	memdelete(parallel);
}

} // namespace

void GrassField::set_fill_rule(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY();
	const Callable changed = callable_mp(this, &GrassField::_fill_rule_changed);
	if (_fill.rule.is_valid()) {
		_fill.rule->disconnect("changed", changed);
	}
	_fill.rule = p_rule;
	if (_fill.rule.is_valid()) {
		_fill.rule->connect("changed", changed);
	} else if (_map.is_valid() && _fill.state.is_set()) { // what the rule filled goes with it
		change_map([&](PaintMap &r_map) { return _fill.state.remove(r_map, on_all_threads); });
	}
	_fill_rule_changed();
	notify_property_list_changed();
}

void GrassField::set_fill_live(bool p_live) {
	GRASS_MAIN_THREAD_ONLY();
	_fill.is_live = p_live;
	if (!p_live && _fill.state.is_set() && Engine::get_singleton()->is_editor_hint()) {
		EditorInterface::get_singleton()->set_object_edited(_map.ptr(), true); // what is filled is saved with it from now on
	}
	_fill.state = LiveFill(); // without it the map keeps what is filled
	update_configuration_warnings();
	notify_property_list_changed();
}

void GrassField::_fill_rule_changed() {
	if (!is_main_thread()) { // a part of the resource changed on another one
		callable_mp(this, &GrassField::_fill_rule_changed).call_deferred();
		return;
	}
	_fill.has_changed = true;
	update_configuration_warnings();
}

// What the field itself does to the map concerns no rule.
template <typename F> FillResult GrassField::change_map(F &&p_change) {
	_fill.is_filling = true;
	const FillResult result = _map->change(p_change);
	_fill.is_filling = false;
	_fill.cells += result.cells;
	return result;
}

void GrassField::look_at_rule() {
	_fill.has_changed = false;
	_fill.revision = GrassExclusion3D::get_revision();
	_fill.frames_to_look = FRAMES_BETWEEN_LOOKS;
	const MapRegion region = MapRegion::of_grid(TileGrid::make(_size.x, _size.y, param(PARAM_DENSITY)));
	_fill.state.set(_fill.rule->get_rule(region), _fill.gatherer.gather(**_fill.rule, this, field_transform()), region);
}

// A field that comes into the tree is full from its first frame on; one that stands is filled piece by piece.
void GrassField::start_fill() {
	if (_fill.rule.is_null() || !_fill.is_live || _fill.state.is_set()) {
		return;
	}
	if (_map.is_null()) {
		make_map();
	}
	look_at_rule();
	if (!_backend) {
		change_map([&](PaintMap &r_map) { return _fill.state.work(r_map, -1, on_all_threads); });
	}
	_fill.has_finished = _fill.state.get_waiting() == 0;
	_fill.replacements = _map->get_replacements();
	_fill.base_density = _map->get_base_density();
}

void GrassField::update_fill() {
	start_fill();
	if (_fill.rule.is_null() || !_fill.state.is_set() || !_map->is_readable()) {
		return;
	}
	if (_fill.has_changed || _fill.revision != GrassExclusion3D::get_revision() || --_fill.frames_to_look <= 0) {
		look_at_rule();
	}
	if (_fill.state.get_waiting() > 0) {
		change_map([&](PaintMap &r_map) { return _fill.state.work(r_map, CHUNKS_A_FRAME, on_all_threads); });
		_fill.has_finished = _fill.state.get_waiting() == 0;
	}
	if (_fill.has_finished) {
		_fill.has_finished = false;
		emit_signal("fill_finished"); // last: who listens may change the field
	}
}

// Somebody changed the map.
void GrassField::touch_fill(const TypedArray<Vector2i> &p_chunks) {
	if (_fill.is_filling || !_fill.state.is_set()) {
		return;
	}
	std::vector<MapKey> keys;
	for (int64_t i = 0; i < p_chunks.size(); i++) {
		const Vector2i chunk = p_chunks[i];
		keys.push_back({ chunk.x, chunk.y });
	}
	const bool is_replaced = _fill.replacements != _map->get_replacements();
	_fill.replacements = _map->get_replacements();
	_fill.state.touch(_map->get_map(), keys, is_replaced);
	if (_fill.base_density != _map->get_base_density()) { // it shows where a chunk is filled with nothing else
		_fill.base_density = _map->get_base_density();
		_fill.state.touch_all();
	}
}

double GrassField::fill(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	ERR_FAIL_COND_V_MSG(p_rule.is_null(), 0.0, message("fill() needs a GrassFillRule."));
	if (find_map("fill") == nullptr) {
		return 0.0;
	}
	if (_fill.state.is_set()) {
		WARN_PRINT(message("fill() while `fill_rule` is live: that rule fills over it as soon as it changes. Turn `fill_live` off."));
	}
	const MapRegion region = MapRegion::of_grid(_standing.setup.grid);
	const FillRule rule = p_rule->get_rule(region);
	const FillSources sources = FillGatherer().gather(**p_rule, this, field_transform());
	return change_map([&](PaintMap &r_map) {
		return grass::fill(r_map, chunks_in(region), region, &rule, sources, on_all_threads);
	}).amount;
}

// The inspector's button: one step of the editor's history.
void GrassField::_fill_pressed() {
	if (_fill.rule.is_null() || !is_inside_tree()) {
		return;
	}
	const bool is_new = _map.is_null();
	if (is_new) {
		make_map();
	}
	const Ref<GrassMapSnapshot> before = _map->take_snapshot();
	fill(_fill.rule);
	EditorUndoRedoManager *history = EditorInterface::get_singleton()->get_editor_undo_redo();
	history->create_action("Fill Grass", UndoRedo::MERGE_DISABLE, this);
	if (is_new) {
		history->add_do_property(this, "map", _map);
		history->add_undo_property(this, "map", Variant());
	}
	history->add_do_method(_map.ptr(), "restore_snapshot", _map->take_snapshot());
	history->add_undo_method(_map.ptr(), "restore_snapshot", before);
	history->commit_action(false); // done already
	EditorInterface::get_singleton()->set_object_edited(_map.ptr(), true);
}

Callable GrassField::get_fill_button() const {
	return callable_mp(const_cast<GrassField *>(this), &GrassField::_fill_pressed);
}

} // namespace grass
