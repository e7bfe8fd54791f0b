// SPDX-License-Identifier: MIT
#include "ground/field_filler.h"

#include "resources/grass_exclusion_3d.h"
#include "resources/grass_path_3d.h"
#include "shared/editor_hooks.h"
#include "shared/parallel.h"
#include "shared/script_call.h"
#include "shared/watch_resource.h"

#include <godot_cpp/core/object.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// Chunks filled in a frame: 65,536 texels. More: frames stutter while a rule is changed. Fewer: a field of 1 km^2 (256 chunks) takes longer
// to follow.
constexpr int CHUNKS_A_FRAME = 4;
// Nodes of the rule's groups send no notification when they move: their places are read at this interval, frames.
constexpr int FRAMES_BETWEEN_LOOKS = 15;

// Returns a number that changes with every node that rules follow automatically.
uint64_t scene_revision() {
	return GrassExclusion3D::get_nodes().get_revision() + GrassPath3D::get_nodes().get_revision();
}

bool has_scene_nodes() {
	return !GrassExclusion3D::get_nodes().is_empty() || !GrassPath3D::get_nodes().is_empty();
}

FillRule rule_for(GrassFillRule &r_rule, const FieldFiller::Place &p_place) {
	FillRule rule = r_rule.get_rule(p_place.region);
	rule.noise_origin = p_place.noise_origin;
	return rule;
}

} // namespace

// Changes the map without queueing the change as one made by others.
template <typename F> bool FieldFiller::change(const Ref<GrassMap> &p_map, FillResult &r_result, F &&p_change) {
	const bool was_filling = std::exchange(_is_filling, true);
	if (!outlives(_node, [&] { r_result = p_map.ptr()->change(p_change); })) {
		return false;
	}
	_is_filling = was_filling;
	_cells += r_result.cells;
	return true;
}

// Fills waiting chunks. p_chunks: the most to fill; negative: all of them.
bool FieldFiller::work(const Ref<GrassMap> &p_map, int p_chunks) {
	FillResult result;
	if (!change(p_map, result, [&](PaintMap &r_map) { return _state.work(r_map, p_chunks, run_parallel); })) {
		return false;
	}
	_has_finished = _state.is_set() && _state.get_waiting() == 0;
	return true;
}

bool FieldFiller::set_rule(const Ref<GrassFillRule> &p_rule, const Callable &p_changed, const Ref<GrassMap> &p_map) {
	if (!watch_instead(_rule, p_rule, p_changed)) {
		return true;
	}
	_gatherer.listen(_rule.is_valid() ? p_changed : Callable());
	if (_rule.is_null() && p_map.is_valid() && _state.is_set()) {
		const Ref<GrassMap> map = p_map; // NOLINT(performance-unnecessary-copy-initialization): a script may drop the field's own
		FillResult result;
		_frames_to_look = 0;
		return change(map, result, [&](PaintMap &r_map) { return _state.remove(r_map, run_parallel); });
	}
	return true;
}

void FieldFiller::set_live(bool p_live, const Ref<GrassMap> &p_map) {
	_is_live = p_live;
	if (!p_live && _state.is_set() && editor_hooks.mark_edited != nullptr) {
		editor_hooks.mark_edited(p_map); // from now on the filled grass is saved with the map
	}
	forget_map(); // without the state the map keeps what was filled
}

bool FieldFiller::read_meshes(const Place &p_place) {
	const Ref<GrassFillRule> rule = _rule; // a script may drop it
	return rule.is_null() || _gatherer.read_meshes(**rule, &_node, p_place.transform);
}

std::optional<FieldFiller::Gathered> FieldFiller::gather(const Place &p_place) {
	const bool is_filled = _rule.is_valid() || _state.is_set();
	return is_filled && _node.is_inside_tree() ? read(p_place) : std::optional<Gathered>();
}

FieldFiller::Gathered FieldFiller::read(const Place &p_place) {
	const bool has_rule = _rule.is_valid();
	if (!has_rule && _no_rule.is_null()) {
		_no_rule.instantiate();
		_no_rule->set_group(GrassFillRule::GROUP_EXCLUSION, StringName());
	}
	GrassFillRule &rule = has_rule ? **_rule : **_no_rule;
	Gathered gathered{ rule_for(rule, p_place), _gatherer.gather(rule, &_node, p_place.transform) };
	gathered.sources.terrain = _terrain;
	if (!has_rule) {
		gathered.rule.params[FILL_DENSITY] = _base_density;
		gathered.rule.only_at_obstacles = true;
	}
	return gathered;
}

bool FieldFiller::is_needed(const Place &p_place) {
	if (!_is_live || _rule.is_valid()) {
		return _is_live;
	}
	const bool may_have_come = _revision != scene_revision() || --_frames_to_look <= 0;
	if (!has_scene_nodes() || !may_have_come) {
		return false;
	}
	_revision = scene_revision();
	_frames_to_look = FRAMES_BETWEEN_LOOKS;
	return std::ranges::any_of(read(p_place).sources.obstacles,
			[&p_place](const auto &p_obstacle) { return p_obstacle->reaches(p_place.region.min, p_place.region.max); });
}

bool FieldFiller::may_fill() const {
	return _state.is_set() || (_is_live && (_rule.is_valid() || has_scene_nodes()));
}

Node3D *FieldFiller::find_node(const FillObstacle *p_obstacle) const {
	return Object::cast_to<Node3D>(ObjectDB::get_instance(_gatherer.get_node_of(p_obstacle)));
}

// Reads what the rule needs. A script of a mesh may take the map, the rule or the field away: then there is nothing to fill.
bool FieldFiller::look(const Place &p_place) {
	_has_changed = false;
	_revision = scene_revision();
	_frames_to_look = FRAMES_BETWEEN_LOOKS;
	const uint64_t maps = _maps;
	if (!read_meshes(p_place)) {
		return false;
	}
	if (maps == _maps && _node.is_inside_tree()) {
		const Gathered now = read(p_place);
		_state.set(now.rule, now.sources, p_place.region);
	}
	return true;
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may drop the field's own map
bool FieldFiller::start(Ref<GrassMap> p_map, const Place &p_place, bool p_at_once) {
	_replacements = p_map->get_replacements();
	_base_density = p_map->get_base_density();
	if (!look(p_place)) {
		return false;
	}
	if (!_state.is_set()) {
		return true;
	}
	_has_finished = _state.get_waiting() == 0;
	return !p_at_once || work(p_map, -1);
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may drop the field's own map
bool FieldFiller::update(Ref<GrassMap> p_map, const Place &p_place) {
	if (!_state.is_set() || p_map.is_null() || !p_map->is_readable()) {
		return true;
	}
	const bool is_due = _has_changed || _revision != scene_revision() || --_frames_to_look <= 0;
	if (is_due && !look(p_place)) {
		return false;
	}
	return !_state.is_set() || _state.get_waiting() == 0 || work(p_map, CHUNKS_A_FRAME);
}

void FieldFiller::touch(const Ref<GrassMap> &p_map, const TypedArray<Vector2i> &p_chunks) {
	if (_is_filling || !_state.is_set()) {
		return;
	}
	std::vector<MapKey> keys;
	for (int64_t i = 0; i < p_chunks.size(); i++) {
		const Vector2i chunk = p_chunks[i];
		keys.push_back({ chunk.x, chunk.y });
	}
	const bool is_replaced = _replacements != p_map->get_replacements();
	_replacements = p_map->get_replacements();
	_state.touch(p_map->get_map(), keys, is_replaced);
	if (_base_density != p_map->get_base_density()) { // it is visible in chunks that contain nothing else
		_base_density = p_map->get_base_density();
		_has_changed = true; // without a rule it is what is filled by
		_state.touch_all();
	}
}

void FieldFiller::set_terrain(const std::shared_ptr<const TerrainIds> &p_ids) {
	_has_changed = _has_changed || _terrain != p_ids;
	_terrain = p_ids;
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): a script that runs meanwhile may drop map and rule
double FieldFiller::fill(Ref<GrassMap> p_map, Ref<GrassFillRule> p_rule, const Place &p_place) {
	FillGatherer gatherer;
	if (!gatherer.read_meshes(**p_rule, &_node, p_place.transform) || !_node.is_inside_tree()) {
		return 0.0;
	}
	const FillRule rule = rule_for(**p_rule, p_place);
	FillSources sources = gatherer.gather(**p_rule, &_node, p_place.transform);
	sources.terrain = _terrain;
	FillResult result;
	(void)change(p_map, result, [&](PaintMap &r_map) { // nothing may follow this
		return grass::fill(r_map, chunks_in(p_place.region), p_place.region, &rule, sources, run_parallel, FillRim::FILLED);
	});
	return result.amount;
}

void FieldFiller::warn(const Ref<GrassMap> &p_map, bool p_has_terrain, PackedStringArray &r_warnings) const {
	if (_rule.is_null()) {
		if (!_is_live && has_scene_nodes()) {
			r_warnings.push_back("`fill_live` is off, so GrassExclusion3D and GrassPath3D do not change this field. Turn it on.");
		}
		return;
	}
	if (_rule->asks_textures() && !_terrain) {
		r_warnings.push_back(
				"`fill_rule` depends on textures (`texture_ids`), but `terrain` is not a node that provides them, so all ground counts.");
	}
	if (_rule->asks_ground() && !p_has_terrain && (p_map.is_null() || !p_map->get_map().uses(MAP_GROUND))) {
		r_warnings.push_back("`fill_rule` depends on slope or height, but the map has no ground, so all ground counts as level, at the "
							 "field's height. Bake the ground.");
	}
	r_warnings.append_array(_rule->find_warnings());
}

void FieldFiller::add_to(FieldStatistics &r_statistics) const {
	r_statistics.fill_cells = _cells;
	r_statistics.fill_waiting = _state.get_waiting();
}

} // namespace grass
