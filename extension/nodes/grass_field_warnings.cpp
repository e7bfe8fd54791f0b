// SPDX-License-Identifier: MIT
// What GrassField warns of: beside the node in the editor, once each in a game's console.
#include "nodes/grass_field.h"

#include <godot_cpp/classes/engine.hpp>

#include <set>
#include <string>

using namespace godot;

namespace grass {

namespace {

// Warnings of refused passes that some field has printed. No String: the engine's memory must not outlive the engine.
std::set<std::string> &told_refusals() {
	static std::set<std::string> told;
	return told;
}

} // namespace

void GrassField::warn(const String &p_warning) const {
	if (_warning_teller) {
		_warning_teller(p_warning);
	} else {
		WARN_PRINT(vformat("%s: %s", label(), p_warning));
	}
}

// Once each, in the console; in the editor beside the node.
void GrassField::report_warnings() {
	if (Engine::get_singleton()->is_editor_hint()) {
		update_configuration_warnings();
		return;
	}
	const PackedStringArray warnings = _get_configuration_warnings();
	const String refusal = _standing.refusal_warning(); // of the first field only: a world has many
	const bool is_told = !refusal.is_empty() && !told_refusals().insert(refusal.utf8().get_data()).second;
	for (const String &warning : warnings) {
		if (!_warned_of.has(warning) && !(is_told && warning == refusal)) {
			warn(warning);
		}
	}
	_warned_of = warnings;
}

PackedStringArray GrassField::_get_configuration_warnings() const {
	PackedStringArray warnings;
	_properties.warn_of_blades(warnings);
	if (is_map_bare() && Engine::get_singleton()->is_editor_hint()) { // a game may begin with bare ground
		warnings.push_back("`map` has no paint and a `base_density` of 0, so no grass grows. Paint with the brush, or set the map's "
						   "`base_density` to 1.");
	}
	if (is_inside_tree()) {
		const Transform3D transform = get_global_transform();
		if (!transform.is_finite()) {
			warnings.push_back("The node's transform is not a number. Set its position and rotation again.");
		} else if (!transform.basis.get_scale().is_equal_approx(Vector3(1, 1, 1))) {
			warnings.push_back("The node's scale is ignored. Use `size` for the field, and the patch's lengths and widths for the blades.");
		}
	}
	_properties.warn_of_tiles(warnings);
	_properties.warn_of_ground(warnings);
	_standing.warn_of_device(warnings);
	if (_standing.is_crowded()) {
		warnings.push_back(_standing.crowded_warning());
	}
	if (_standing.is_budget_blind()) {
		warnings.push_back(StandingField::blind_warning());
	}
	_properties.hook.warn(warnings);
	_filler.warn(_properties.map, _terrain.is_found(), warnings);
	_terrain.warn(warnings);
	return warnings;
}

} // namespace grass
