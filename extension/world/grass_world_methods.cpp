// SPDX-License-Identifier: MIT
// The methods of a world that scripts call.
#include "world/grass_world.h"

#include "draw/frame_share.h"
#include "field/work_limits.h"
#include "resources/map_painting.h"
#include "shared/main_thread.h"
#include "shared/script_call.h"

#include <godot_cpp/classes/engine.hpp>

#include <algorithm>

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
	const PlotKey key = grid().at(place_of(p_global_position));
	return Vector2i(key.x, key.z);
}

String GrassWorld::get_plot_path(const Vector2i &p_plot) const {
	return WorldFiles::path_of(find_folders().place.to, { p_plot.x, p_plot.y });
}

GrassField *GrassWorld::get_field(const Vector2i &p_plot) const {
	return _plots.find({ p_plot.x, p_plot.y });
}

GrassField *GrassWorld::get_field_at(const Vector3 &p_global_position) const {
	return is_inside_tree() && p_global_position.is_finite() ? _plots.find(grid().at(place_of(p_global_position))) : nullptr;
}

TypedArray<GrassField> GrassWorld::get_fields() const {
	TypedArray<GrassField> fields;
	for (const PlotKey &key : _plots.get_standing()) {
		fields.push_back(_plots.find(key));
	}
	return fields;
}

Dictionary GrassWorld::cut(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	Dictionary sum = to_script(CutResult());
	GRASS_MAIN_THREAD_ONLY_V(sum);
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), sum, vformat("%s: cut() needs a finite transform.", label()));
	double area = 0.0;
	for (const PlotKey &key : _plots.get_standing()) {
		area += _plots.find(key) != nullptr ? _plots.find(key)->get_parts().work.find_area(p_shape, p_transform) : 0.0;
	}
	ERR_FAIL_COND_V_MSG(area > double(AREA_MAX), sum,
			vformat("%s: cut() would act on %.0f square metres, and acts on %d at most (AREA_MAX). Call it with several smaller shapes, in "
					"as many frames.",
					label(), area, AREA_MAX));
	const Array names = sum.keys();
	for (const PlotKey &key : _plots.get_standing()) {
		GrassField *field = _plots.find(key);
		Dictionary cut;
		if (field != nullptr && !outlives(*this, [&] { cut = to_script(field->get_parts().work.cut(p_shape, p_transform)); })) {
			return sum; // a listener of the map freed the world
		}
		for (int64_t i = 0; i < names.size(); i++) {
			const Variant before = sum[names[i]], more = cut.get(names[i], 0);
			sum[names[i]] =
					before.get_type() == Variant::INT ? Variant(int64_t(before) + int64_t(more)) : Variant(double(before) + double(more));
		}
	}
	return sum;
}

double GrassWorld::paint(const Ref<GrassBrush> &p_brush, const Vector3 &p_from, const Vector3 &p_to) {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	if (!is_here("paint")) {
		return 0.0;
	}
	const String problem = problem_of_stroke(p_brush, Vector2(p_from.x, p_from.z), Vector2(p_to.x, p_to.z));
	ERR_FAIL_COND_V_MSG(!problem.is_empty() || !p_from.is_finite() || !p_to.is_finite(), 0.0,
			vformat("%s: paint(): %s", label(), problem.is_empty() ? String("the ends of a stroke must be finite numbers.") : problem));
	const Eigen::Vector2d from = place_of(p_from), to = place_of(p_to);
	const double reach = p_brush->get_reach() + MapLayers::CHANGE_MARGIN; // a neighbour's edge is blended with this one's
	double sum = 0.0;
	for (const PlotKey &key : _plots.get_standing()) {
		GrassField *field = _plots.find(key);
		if (field != nullptr && _plots.get_grid().distance(key, from, to) <= reach) {
			double changed = 0.0;
			const bool lives = outlives(*this, [&] { changed = field->get_parts().work.paint(p_brush, p_from, p_to); });
			sum += changed;
			if (!lives) { // a listener of the map freed the world
				return sum;
			}
		}
	}
	return sum;
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
	ERR_FAIL_COND_V_MSG(find_folders().place.to.is_empty(), 0,
			vformat("%s: save() needs a folder. Set `%s`.", label(),
					String(Engine::get_singleton()->is_editor_hint() ? "folder" : "save_folder")));
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
	ERR_FAIL_COND_MSG(!grid().has({ p_plot.x, p_plot.y }),
			vformat("%s: restore_plot(): (%d, %d) is not a plot of this world.", label(), p_plot.x, p_plot.y));
	_plots.restore({ p_plot.x, p_plot.y }, p_from->map, p_snapshot->map);
}

void GrassWorld::wait_for_files() {
	GRASS_MAIN_THREAD_ONLY();
	_plots.get_files().wait();
}

Dictionary GrassWorld::get_statistics() const {
	const WorldStatistics plots = _plots.get_statistics();
	const WorldFileStatistics files = _plots.get_files().get_statistics();
	Dictionary result;
	result["plots"] = plots.plots;
	result["waiting"] = plots.waiting;
	result["changed"] = plots.changed;
	result["spare"] = plots.spare;
	result["memory"] = plots.memory;
	result["reach"] = std::min(_plots.get_plan().reach, _camera_radius);
	result["distance_tests"] = plots.tests;
	result["brought"] = plots.brought;
	result["left"] = plots.left;
	result["fields_made"] = plots.fields_made;
	result["most_moves"] = plots.most_moves;
	const FrameShare::Most most = FrameShare::get_most();
	result["most_parts"] = most.parts;
	result["most_bytes"] = most.bytes;
	result["most_build_ms"] = plots.most_build_ms;
	result["bodies"] = _eyes.get_body_count();
	result["files_waiting"] = files.waiting;
	result["files_read"] = files.read;
	result["files_written"] = files.written;
	result["files_refused"] = files.refused;
	result["files_kept"] = files.kept;
	result["files_kept_elsewhere"] = files.kept_elsewhere;
	result["bytes_read"] = files.bytes_read;
	result["bytes_written"] = files.bytes_written;
	result["frame_ms"] = _frame_ms;
	result["most_frame_ms"] = _most_frame_ms;
	return result;
}

} // namespace grass
