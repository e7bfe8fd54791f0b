// SPDX-License-Identifier: MIT
// The methods of a world that scripts call.
#include "world/grass_world.h"

#include "shared/main_thread.h"
#include "shared/script_call.h"
#include "world/world_place.h"

using namespace godot;

namespace grass {

namespace {

// Metres from the origin to which shift_origin() may move the world. More: two neighbouring numbers are more than a metre apart.
constexpr double FARTHEST = 1e7;

} // namespace

// Places are global, and outside of the tree nothing is.
bool GrassWorld::is_here(const char *p_method) const {
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), false, vformat("%s: %s() needs the world in the tree. Add it first.", label(), p_method));
	return true;
}

Vector2i GrassWorld::get_plot_at(const Vector3 &p_global_position) const {
	if (!is_here("get_plot_at")) {
		return Vector2i();
	}
	ERR_FAIL_COND_V_MSG(!p_global_position.is_finite(), Vector2i(), vformat("%s: get_plot_at() needs a finite position.", label()));
	const PlotKey key = _properties.grid().at(place_in(*this, p_global_position));
	return Vector2i(key.x, key.z);
}

String GrassWorld::get_plot_path(const Vector2i &p_plot) const {
	return WorldFiles::path_of(_properties.place().to, { p_plot.x, p_plot.y });
}

GrassField *GrassWorld::get_field(const Vector2i &p_plot) const {
	return _plots.find({ p_plot.x, p_plot.y });
}

GrassField *GrassWorld::get_field_at(const Vector3 &p_global_position) const {
	return is_inside_tree() && p_global_position.is_finite() ? _plots.find(_properties.grid().at(place_in(*this, p_global_position)))
															 : nullptr;
}

TypedArray<GrassField> GrassWorld::get_fields() const {
	TypedArray<GrassField> fields;
	for (const PlotKey &key : _plots.get_standing()) {
		fields.push_back(_plots.find(key));
	}
	return fields;
}

void GrassWorld::shift_origin(const Vector3 &p_offset) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!p_offset.is_finite(), vformat("%s: shift_origin() needs a finite offset.", label()));
	const Vector3 from = is_inside_tree() ? get_global_position() : get_position(), to = from + p_offset;
	ERR_FAIL_COND_MSG(!(double(to.length()) <= FARTHEST) && !(to.length() < from.length()),
			vformat("%s: shift_origin() would put the world %.0f km from the origin, where there is no room between two numbers for a "
					"blade. "
					"Pass the way by which the origin moves, so that the player is near it again.",
					label(), double(to.length()) * 1e-3));
	if (is_inside_tree()) {
		set_global_position(to);
	} else { // as it will be, below a node that is not turned
		set_position(to);
	}
}

int64_t GrassWorld::save() {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(_properties.place().to.is_empty(), 0,
			vformat("%s: save() needs a folder. Set `%s`.", label(), String(WorldProperties::is_edited() ? "folder" : "save_folder")));
	const int64_t kept = _plots.get_files().count_writable(), changed = _plots.save();
	_plots.get_files().write_kept();
	return kept + changed;
}

int64_t GrassWorld::carry_unsaved() {
	GRASS_MAIN_THREAD_ONLY_V(0);
	const bool is_running = _plots.is_running();
	_plots.stop();
	const int64_t count = _plots.get_files().carry_kept();
	if (outlives(*this, [&] { restart(); }) && is_running && !find_folders().keeps) {
		_plots.get_files().write_kept();
	}
	return count;
}

int64_t GrassWorld::discard_unsaved() {
	GRASS_MAIN_THREAD_ONLY_V(0);
	_plots.get_files().wait(); // plots that left were changed, too
	const int64_t changed = _plots.get_statistics().changed;
	_plots.stop(true);
	const int64_t count = changed + _plots.get_files().discard_kept();
	restart();
	return count;
}

void GrassWorld::discard_kept_elsewhere() {
	_plots.get_files().discard_kept_elsewhere();
	update_configuration_warnings();
}

bool GrassWorld::has_unsaved() const {
	return _plots.get_files().get_statistics().kept > 0 || _plots.get_statistics().changed > 0;
}

void GrassWorld::restore_plot(const Vector2i &p_plot, const Ref<GrassMapSnapshot> &p_snapshot, const Ref<GrassMapSnapshot> &p_from) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(
			p_snapshot.is_null() || p_from.is_null(), vformat("%s: restore_plot() needs snapshots from a map's take_snapshot().", label()));
	ERR_FAIL_COND_MSG(!_properties.grid().has({ p_plot.x, p_plot.y }),
			vformat("%s: restore_plot(): (%d, %d) is not a plot of this world.", label(), p_plot.x, p_plot.y));
	_plots.restore({ p_plot.x, p_plot.y }, p_from->map, p_snapshot->map);
}

void GrassWorld::wait_for_files() {
	GRASS_MAIN_THREAD_ONLY();
	_plots.get_files().wait();
}

} // namespace grass
