// SPDX-License-Identifier: MIT
#include "ground/bare_answer.h"

#include "core/field/bare_cause.h"
#include "core/field/grass_at.h"
#include "field/field_device.h"
#include "field/field_places.h"
#include "field/project_pool.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double FULL = 0.99; // share that counts as full, since painted codes are rounded

String rounded(double p_value, int p_decimals) {
	return String::num(p_value, p_decimals);
}

int64_t percent(double p_share) {
	return int64_t(std::llround(100.0 * p_share));
}

// Returns what hides the grass of the whole field; NONE if nothing does.
BareAnswer explain_field(
		const GeometryInstance3D &p_node, const StandingField &p_standing, const Vector3 &p_place, const Camera3D *p_camera) {
	if (!p_standing.stands()) {
		return { BareReason::NOT_MADE, "There is no grass yet: the field is not made yet, or its species have no blades." };
	}
	if (!p_node.is_visible_in_tree()) {
		return { BareReason::HIDDEN, "No grass is drawn: the field, or a node above it, is hidden." };
	}
	if (p_camera == nullptr) {
		return {};
	}
	if ((int64_t(p_camera->get_cull_mask()) & int64_t(p_node.get_layer_mask())) == 0) {
		return { BareReason::LAYERS, "No grass is drawn for this camera: `cull_mask` of the camera has none of the field's `layers`." };
	}
	const double distance = (p_camera->get_global_position() - p_place).length();
	if (distance > p_camera->get_far()) {
		return { BareReason::TOO_FAR,
			vformat("No grass is drawn here: %s m from the camera, whose `far` is %s m.", rounded(distance, 0),
					rounded(p_camera->get_far(), 1)) };
	}
	return {};
}

struct Words {
	BareReason reason;
	String text;
	Node3D *node = nullptr;
};

Words words_of(const FillCause &p_cause, const FillRule &p_rule, FieldFiller &r_filler) {
	const auto limits = [&](FillParamId p_min, FillParamId p_max, const char *p_what) {
		const String unit = unit_of(FILL_PARAMS[p_min]);
		return vformat("%s of %s %s (`%s` %s, `%s` %s)", p_what, rounded(p_cause.value, 1), unit, FILL_PARAMS[p_min].name,
				rounded(p_rule.get(p_min), 1), FILL_PARAMS[p_max].name, rounded(p_rule.get(p_max), 1));
	};
	switch (p_cause.condition) {
		case FillCondition::DENSITY:
			return { BareReason::FILL_DENSITY, vformat("the rule's `density` is %s", rounded(p_rule.get(FILL_DENSITY), 2)) };
		case FillCondition::MASK:
			return { BareReason::FILL_MASK, "the rule's `mask`" };
		case FillCondition::MESH:
			return { BareReason::FILL_MESH, "the meshes of the rule's `mask_group`" };
		case FillCondition::TEXTURE:
			return { BareReason::FILL_TEXTURE,
				p_cause.value < 0.0 ? String("the textures of the `terrain`, which have not been read here yet")
									: vformat("texture %d of the `terrain` (`texture_ids` %s)", int64_t(p_cause.value),
											  r_filler.get_rule()->get_texture_ids()) };
		case FillCondition::SLOPE:
			return { BareReason::FILL_SLOPE, limits(FILL_SLOPE_MIN, FILL_SLOPE_MAX, "a slope") };
		case FillCondition::HEIGHT:
			return { BareReason::FILL_HEIGHT, limits(FILL_HEIGHT_MIN, FILL_HEIGHT_MAX, "a height") };
		case FillCondition::NOISE:
			return { BareReason::FILL_NOISE, vformat("the rule's noise (`noise_cover` %s)", rounded(p_rule.get(FILL_NOISE_COVER), 2)) };
		default:
			break;
	}
	Node3D *node = r_filler.find_node(p_cause.obstacle.get());
	const String name = node == nullptr ? String("a node that no longer exists") : vformat("%s '%s'", node->get_class(), node->get_name());
	return { BareReason::FILL_NODE, name, node };
}

String standing_words(const BareAnswer &p_answer) {
	if (p_answer.density <= 0.0) {
		return "No grass grows here";
	}
	if (p_answer.density < FULL) {
		return vformat("%d %% of the grass grows here", percent(p_answer.density));
	}
	return vformat("Grass of %d cm grows here", percent(p_answer.height));
}

// Returns the words of a cause. p_rule: the one that fills the map; null: none.
Words words_of(const BareCause &p_cause, const PaintMap &p_map, const FillRule *p_rule, FieldFiller &r_filler) {
	switch (p_cause.kind) {
		case BareKind::MAP:
			return { BareReason::MAP,
				vformat("the map has a density of %s (not painted; `base_density` is %s)", rounded(p_cause.share, 2),
						rounded(p_map.get_base_density(), 2)) };
		case BareKind::PAINTED:
			return { BareReason::PAINTED, vformat("painted to a density of %s", rounded(p_cause.share, 2)) };
		case BareKind::WORN:
			return { BareReason::WORN, "it is trampled" };
		case BareKind::SHORT:
			return { BareReason::SHORT, vformat("painted to %d %% of its height", percent(p_cause.share)) };
		case BareKind::CUT:
			return { BareReason::CUT, vformat("cut at %d cm", percent(p_cause.value)) };
		case BareKind::HOLE:
			return { BareReason::HOLE, "the terrain has a hole here" };
		case BareKind::LEDGE:
			return { BareReason::LEDGE, "it is at the edge of a ledge, or on its face (`ledge_slope`)" };
		default:
			break;
	}
	Words words = words_of(p_cause.rule, *p_rule, r_filler);
	const String left = p_cause.rule.share > 0.0 ? vformat("%d %%", percent(p_cause.rule.share)) : String("none");
	words.text = p_rule->only_at_obstacles ? vformat("%s leaves %s", words.text, left)
										   : vformat("`fill_rule` leaves %s because of %s", left, words.text);
	return words;
}

// Explains the place by the map.
void explain_map(BareAnswer &r_answer, const Field &p_field, FieldFiller &r_filler, const FieldFiller::Place &p_fill, const PaintMap &p_map,
		const Eigen::Vector2d &p_at) {
	const auto gathered = r_filler.gather(p_fill);
	const FillRule *rule = gathered ? &gathered->rule : nullptr;
	const GrassKind kind = kind_of(p_field);
	const double height = kind.height_at ? kind.height_at(p_at) : kind.height;
	const BareCause cause = find_bare_cause(p_map, rule, gathered ? gathered->sources : FillSources(), p_at, height);
	if (cause.share < FULL) {
		const Words words = words_of(cause, p_map, rule, r_filler);
		r_answer.reason = words.reason;
		r_answer.node = words.node;
		r_answer.text = vformat("%s: %s.", standing_words(r_answer), words.text);
	}
}

// Explains a place above or below the field's band.
BareAnswer explain_level(const Node &p_node, const GroundBand &p_band, double p_height, Node3D *p_other) {
	const auto limit = [](double p_value) { return String::num(p_value, 2); };
	const String other = p_other == nullptr ? String("No other field has its ground here")
											: vformat("The grass here is that of '%s'", p_other->get_name());
	return { BareReason::LEVEL,
		vformat("No grass of '%s' grows here: the place is %s m %s it, and its ground is from %s to %s m (`ground_low`, "
				"`ground_high`). %s.",
				p_node.get_name(), rounded(std::abs(p_height), 1), p_height < 0.0 ? "below" : "above", limit(p_band.low),
				limit(p_band.high), other),
		p_other };
}

String still_words(bool p_is_simulated, const TileManager &p_tiles) {
	if (!p_is_simulated) {
		return " Nothing bends it: `simulated` is off.";
	}
	const int64_t own = p_tiles.get_params().pool_size;
	if (p_tiles.get_limit() >= own) {
		return vformat(" Nothing bends it: all %d tiles of the pool are awake elsewhere (`pool_tiles`).", own);
	}
	return vformat(" Nothing bends it: all %d tiles that fields may have awake together are awake elsewhere (the project setting %s).",
			int64_t(project_pool()->get_slots()), POOL_SETTING);
}

} // namespace

BareAnswer explain_place(const GeometryInstance3D &p_node, const StandingField &p_standing, FieldFiller &r_filler,
		const FieldProperties &p_properties, const FieldFiller::Place &p_fill, const Vector3 &p_place, const Camera3D *p_camera,
		Node3D *p_other) {
	BareAnswer answer = explain_field(p_node, p_standing, p_place, p_camera);
	if (answer.reason != BareReason::NONE) {
		return answer;
	}
	const GroundBand band = p_properties.ground_band();
	const FieldPlaces places(p_standing, p_fill.transform, band);
	const std::optional<TilePlace> tile = places.find_tile(p_place);
	if (!tile) {
		return { BareReason::OUTSIDE, "No grass grows here: the place is outside the field (`size`)." };
	}
	const Eigen::Vector3d place = to_eigen(p_fill.transform).inverse(Eigen::Isometry) * to_eigen(p_place);
	if (!band.contains(place.y())) {
		return explain_level(p_node, band, place.y(), p_other);
	}
	answer.density = places.density_at(p_place);
	answer.height = places.height_at(p_place);
	const Field &field = p_standing.get_field();
	if (p_properties.map.is_valid()) {
		explain_map(answer, field, r_filler, p_fill, p_properties.map->get_map(), { place.x(), place.z() });
	}
	if (answer.reason == BareReason::NONE && p_standing.is_crowded()) {
		return { BareReason::NO_ROOM, crowded_warning(p_standing.get_field().get_setup()), nullptr, answer.density, answer.height,
			answer.is_still };
	}
	if (answer.reason == BareReason::NONE) {
		answer.text = standing_words(answer) + ".";
	}
	const TileManager &tiles = field.get_tiles();
	const bool is_full = tiles.get_statistics().awake >= tiles.get_limit();
	const bool is_awake = tiles.is_awake(field.get_grid().get_index(tile->x, tile->z));
	answer.is_still = !p_properties.simulated || (is_full && !is_awake);
	if (answer.density > 0.0 && answer.is_still) {
		answer.text += still_words(p_properties.simulated, tiles);
	}
	return answer;
}

Dictionary to_dictionary(const BareAnswer &p_answer) {
	Dictionary result;
	result["reason"] = int64_t(p_answer.reason);
	result["text"] = p_answer.text;
	result["node"] = p_answer.node != nullptr ? Variant(p_answer.node) : Variant();
	result["density"] = p_answer.density;
	result["height"] = p_answer.height;
	result["still"] = p_answer.is_still;
	return result;
}

} // namespace grass
