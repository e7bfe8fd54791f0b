// SPDX-License-Identifier: MIT
#include "world/world_report.h"

#include "draw/frame_share.h"
#include "shared/label.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace grass {

namespace {

bool is_exported() {
	return FileAccess::file_exists("res://project.binary");
}

} // namespace

void WorldReport::restart() {
	_most_frame_ms = 0.0;
	_shortage = {};
	_has_printed = false;
}

void WorldReport::count_frame(double p_ms) {
	_frame_ms = p_ms;
	_most_frame_ms = std::max(_most_frame_ms, p_ms);
}

PackedStringArray WorldReport::find_warnings() const {
	PackedStringArray warnings;
	if (_plots.get_fields().has_wrong_scene()) {
		warnings.push_back("The root of `plot_scene` is not a GrassField, so plots use the defaults. Choose a scene whose root is one.");
	}
	const String to = _properties.place().to;
	if (to.is_empty() && WorldProperties::is_edited()) {
		warnings.push_back(
				"`folder` is empty, so plots that are painted here are not saved with the scene. Set it, to a folder in res:// for "
				"instance.");
	} else if (to.is_empty()) {
		warnings.push_back(
				"`folder` and `save_folder` are empty: what is cut, worn and painted is kept in memory and lost with the game. Set "
				"`save_folder`, to a folder in user:// for instance.");
	}
	const double tile_size = _plots.get_fields().get_pattern().tile_size, tiles = tile_size > 0.0 ? _properties.plot_size / tile_size : 0.0;
	if (std::abs(tiles - std::round(tiles)) > 1e-6) {
		const double fitting = 64.0 * std::round(tiles) * std::round(tiles) / (_properties.plot_size * _properties.plot_size);
		warnings.push_back(vformat("`density` of `plot_scene` makes tiles that do not fit `plot_size`, so plots overlap or leave gaps of "
								   "some decimetres. Set `density` to %.2f.",
				fitting));
	}
	if (const String problem = _plots.get_files().find_problem(); !problem.is_empty()) {
		warnings.push_back(problem);
	}
	if (_properties.folder.begins_with("res://") && is_exported() && WorldFiles::find_plots(_properties.folder).is_empty()) {
		warnings.push_back(vformat("`folder` ('%s') holds no plot, so grass stands as if nothing had been painted. If it was painted, the "
								   "export left its files out: export once more and read what it says about GrassField, or add '%s' to "
								   "the export filters for non-resource files.",
				_properties.folder, _properties.folder.trim_prefix("res://").path_join("*.grassmap")));
	}
	if (const int64_t elsewhere = _plots.get_files().get_statistics().kept_elsewhere; elsewhere > 0) {
		warnings.push_back(
				vformat("Changes of %d plots were never written, and belong to other folders or to another `plot_size`. save() writes them "
						"to their own folder, if they have one. carry_unsaved() brings them here, discard_unsaved() discards them.",
						elsewhere));
	}
	return warnings;
}

String WorldReport::describe_shortage() const {
	if (!_shortage.is_short) {
		return String();
	}
	if (_shortage.missing > 0) {
		return vformat("`memory_budget` (%d MB) does not hold the plots that cameras and moving bodies are in: they take %d MB more, and "
					   "there is no "
					   "grass around them. Raise `memory_budget`, or lower `pool_tiles` and `density` of `plot_scene`.",
				int64_t(_properties.memory_budget), int64_t(_shortage.missing / 1000000) + 1);
	}
	return vformat(
			"`memory_budget` (%d MB) holds grass up to %d m around the cameras and moving bodies, not up to `camera_radius` (%d m). Raise "
			"`memory_budget`, lower `camera_radius`, or lower `pool_tiles` and `density` of `plot_scene`.",
			int64_t(_properties.memory_budget), int64_t(_shortage.reach), int64_t(_properties.camera_radius));
}

PackedStringArray WorldReport::get_warnings() const {
	PackedStringArray warnings = find_warnings();
	if (const String shortage = describe_shortage(); !shortage.is_empty()) {
		warnings.push_back(shortage);
	}
	return warnings;
}

bool WorldReport::Shortage::is_worse_than(const Shortage &p_other) const {
	return is_short && (!p_other.is_short || reach < 0.5 * p_other.reach || missing > 2 * p_other.missing);
}

void WorldReport::print_warnings() {
	const WorldPlan &plan = _plots.get_plan();
	const Shortage now{ plan.is_short, plan.reach, plan.missing };
	const bool is_worse = now.is_worse_than(_shortage);
	if (WorldProperties::is_edited()) {
		if (is_worse || now.is_short != _shortage.is_short) {
			_shortage = now;
			_world.update_configuration_warnings();
		}
		return;
	}
	if (is_worse) {
		_shortage = now;
		WARN_PRINT(vformat("%s: %s", label_of(_world), describe_shortage()));
	}
	if (!std::exchange(_has_printed, true)) {
		const PackedStringArray warnings = find_warnings();
		for (const String &warning : warnings) {
			if (!_warned_of.has(warning)) {
				WARN_PRINT(vformat("%s: %s", label_of(_world), warning));
			}
		}
		_warned_of = warnings;
	}
}

// Prints what was lost. In the editor the user was asked when the scene was closed.
void WorldReport::print_loss() const {
	const int64_t kept = WorldProperties::is_edited() ? 0 : _plots.get_files().get_statistics().kept;
	if (kept > 0) {
		WARN_PRINT(vformat("%s: it was freed with unwritten changes of %d plots, which are lost. Before that, call save() with a "
						   "`save_folder` that can be written to, or discard_unsaved() if they are not wanted.",
				label_of(_world), kept));
	}
}

Dictionary WorldReport::get_statistics() const {
	const WorldStatistics plots = _plots.get_statistics();
	const WorldFileStatistics files = _plots.get_files().get_statistics();
	Dictionary result;
	result["plots"] = plots.plots;
	result["waiting"] = plots.waiting;
	result["changed"] = plots.changed;
	result["memory"] = plots.memory;
	result["reach"] = std::min(_plots.get_plan().reach, _properties.camera_radius);
	result["distance_tests"] = plots.tests;
	result["brought"] = plots.brought;
	result["left"] = plots.left;
	result["fields_made"] = plots.fields_made;
	result["most_moves"] = plots.most_moves;
	const FrameShare::Most most = FrameShare::get_most();
	result["most_parts"] = most.parts;
	result["most_bytes"] = most.bytes;
	result["bodies"] = _eyes.get_body_count();
	result["files_waiting"] = files.waiting;
	result["files_read"] = files.read;
	result["files_written"] = files.written;
	result["files_refused"] = files.refused;
	result["files_kept"] = files.kept;
	result["files_kept_elsewhere"] = files.kept_elsewhere;
	result["frame_ms"] = _frame_ms;
	result["most_frame_ms"] = _most_frame_ms;
	return result;
}

} // namespace grass
