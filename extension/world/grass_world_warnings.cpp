// SPDX-License-Identifier: MIT
// What a world reports to its user: warnings, questions in the editor, and lost changes.
#include "world/grass_world.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

bool is_exported() {
	return FileAccess::file_exists("res://project.binary");
}

} // namespace

PackedStringArray GrassWorld::find_warnings() const {
	PackedStringArray warnings;
	if (_plots.get_fields().has_wrong_scene()) {
		warnings.push_back("The root of `plot_scene` is not a GrassField, so plots use the defaults. Choose a scene whose root is one.");
	}
	if (find_folders().place.to.is_empty() && Engine::get_singleton()->is_editor_hint()) {
		warnings.push_back(
				"`folder` is empty, so plots that are painted here are not saved with the scene. Set it, to a folder in res:// for "
				"instance.");
	} else if (find_folders().place.to.is_empty()) {
		warnings.push_back(
				"`folder` and `save_folder` are empty: what is cut, worn and painted is kept in memory and lost with the game. Set "
				"`save_folder`, to a folder in user:// for instance.");
	}
	const double tile_size = _plots.get_fields().get_pattern().tile_size, tiles = tile_size > 0.0 ? _plot_size / tile_size : 0.0;
	if (std::abs(tiles - std::round(tiles)) > 1e-6) {
		const double fitting = 64.0 * std::round(tiles) * std::round(tiles) / (_plot_size * _plot_size);
		warnings.push_back(vformat("`density` of `plot_scene` makes tiles that do not fit `plot_size`, so plots overlap or leave gaps of "
								   "some decimetres. Set `density` to %.2f.",
				fitting));
	}
	if (const String problem = find_folder_problem(); !problem.is_empty()) {
		warnings.push_back(problem);
	}
	if (_folder.begins_with("res://") && is_exported() && WorldFiles::find_plots(_folder).is_empty()) {
		warnings.push_back(vformat("`folder` ('%s') holds no plot, so grass stands as if nothing had been painted. If it was painted, the "
								   "export left its files out: export once more and read what it says about GrassField, or add '%s' to "
								   "the export filters for non-resource files.",
				_folder, _folder.trim_prefix("res://").path_join("*.grassmap")));
	}
	if (const int64_t elsewhere = count_kept_elsewhere(); elsewhere > 0) {
		warnings.push_back(
				vformat("Changes of %d plots were never written, and belong to other folders or to another `plot_size`. save() writes them "
						"to their own folder, if they have one. carry_unsaved() brings them here, discard_unsaved() discards them.",
						elsewhere));
	}
	return warnings;
}

String GrassWorld::find_shortage() const {
	if (!_shortage.is_short) {
		return String();
	}
	if (_shortage.missing > 0) {
		return vformat("`memory_budget` (%d MB) does not hold the plots that cameras and moving bodies are in: they take %d MB more, and "
					   "there is no "
					   "grass around them. Raise `memory_budget`, or lower `pool_tiles` and `density` of `plot_scene`.",
				int64_t(_memory_budget), int64_t(_shortage.missing / 1000000) + 1);
	}
	return vformat(
			"`memory_budget` (%d MB) holds grass up to %d m around the cameras and moving bodies, not up to `camera_radius` (%d m). Raise "
			"`memory_budget`, lower `camera_radius`, or lower `pool_tiles` and `density` of `plot_scene`.",
			int64_t(_memory_budget), int64_t(_shortage.reach), int64_t(_camera_radius));
}

PackedStringArray GrassWorld::_get_configuration_warnings() const {
	PackedStringArray warnings = find_warnings();
	if (const String shortage = find_shortage(); !shortage.is_empty()) {
		warnings.push_back(shortage);
	}
	return warnings;
}

bool GrassWorld::Shortage::is_worse_than(const Shortage &p_other) const {
	return is_short && (!p_other.is_short || reach < 0.5 * p_other.reach || missing > 2 * p_other.missing);
}

// Prints each warning once, and again when the budget falls far shorter than reported; in the editor the node shows them.
void GrassWorld::report() {
	const WorldPlan &plan = _plots.get_plan();
	const Shortage now{ plan.is_short, plan.reach, plan.missing };
	const bool is_worse = now.is_worse_than(_shortage);
	if (Engine::get_singleton()->is_editor_hint()) {
		if (is_worse || now.is_short != _shortage.is_short) {
			_shortage = now;
			update_configuration_warnings();
		}
		return;
	}
	if (is_worse) {
		_shortage = now;
		WARN_PRINT(vformat("%s: %s", label(), find_shortage()));
	}
	if (!_has_reported) {
		_has_reported = true;
		const PackedStringArray warnings = find_warnings();
		for (const String &warning : warnings) {
			if (!_warned_of.has(warning)) {
				WARN_PRINT(vformat("%s: %s", label(), warning));
			}
		}
		_warned_of = warnings;
	}
}

// Runs after a folder or the plots' size has changed.
void GrassWorld::ask_about_kept() {
	if (places_changed != nullptr && Engine::get_singleton()->is_editor_hint() && count_kept_elsewhere() > 0) {
		places_changed(*this);
	}
}

// Runs before the node leaves the tree. In the editor the user was asked when the scene was closed.
void GrassWorld::report_loss() {
	_plots.stop();
	const int64_t kept = Engine::get_singleton()->is_editor_hint() ? 0 : _plots.get_files().get_statistics().kept;
	if (kept > 0) {
		WARN_PRINT(vformat("%s: it was freed with unwritten changes of %d plots, which are lost. Before that, call save() with a "
						   "`save_folder` that can be written to, or discard_unsaved() if they are not wanted.",
				label(), kept));
	}
}

} // namespace grass
