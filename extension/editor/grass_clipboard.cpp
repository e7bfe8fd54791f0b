// SPDX-License-Identifier: MIT
#include "editor/grass_clipboard.h"

#include "editor/field_owner.h"
#include "editor/painted_fields.h"
#include "shared/convert.h"

#include <godot_cpp/classes/editor_interface.hpp>

#include <set>

using namespace godot;

namespace grass {

namespace {

uint64_t edited_scene() {
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	return root != nullptr ? root->get_instance_id() : 0;
}

} // namespace

void GrassClipboard::copy_field(const GrassField &p_field) {
	copy(p_field, Eigen::Vector2d::Zero(), 0.5 * to_eigen(p_field.get_parts().settings.get_size()), false);
}

void GrassClipboard::copy_circle(const GrassField &p_field, const Eigen::Vector2d &p_middle, double p_radius) {
	copy(p_field, p_middle, Eigen::Vector2d::Constant(p_radius), true);
}

// Copies an area. Without a map grass grows everywhere.
void GrassClipboard::copy(const GrassField &p_field, const Eigen::Vector2d &p_middle, const Eigen::Vector2d &p_half, bool p_is_round) {
	PaintMap map;
	map.set_base_density(1.0);
	_area = { p_field.get_map().is_valid() ? p_field.get_map()->copy() : map, p_middle, p_half, p_is_round };
	_planted = p_field.get_species().duplicate();
}

void GrassClipboard::copy_species(const GrassField &p_field) {
	_palette = p_field.get_species().duplicate();
	_palette_scene = edited_scene();
}

TypedArray<GrassSpecies> GrassClipboard::make_palette() const {
	TypedArray<GrassSpecies> palette = _palette.duplicate();
	for (int64_t i = 0; i < palette.size() && _palette_scene != edited_scene(); i++) {
		palette[i] = own_if_inside(palette[i]);
	}
	return palette;
}

int GrassClipboard::paste(const GrassField &p_field, GrassMap &r_map, const Eigen::Vector2d &p_middle) const {
	const TypedArray<GrassSpecies> species = p_field.get_species();
	std::set<int> missing;
	const auto number_here = [&](int p_number) {
		const std::optional<int64_t> here = find_species(_planted, p_number, species);
		if (!here) {
			missing.insert(p_number);
		}
		return int(here.value_or(-1));
	};
	const Ref<GrassMapSnapshot> after = r_map.take_snapshot();
	paste_area(_area, p_middle, number_here, after->map);
	r_map.restore_snapshot(after);
	return int(missing.size());
}

} // namespace grass
