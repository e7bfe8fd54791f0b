// SPDX-License-Identifier: MIT
#include "resources/grass_fill_rule.h"

#include "shared/bind_property.h"
#include "shared/convert.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/picture.h"
#include "shared/watch_resource.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <utility>

using namespace godot;

namespace grass {

GrassFillRule::GrassFillRule() {
	_groups[GROUP_EXCLUSION] = "grass_exclusion";
}

void GrassFillRule::set_seed(int64_t p_seed) {
	GRASS_CHANGE_GUARD(label());
	replace_in(*this, _rule.seed, uint32_t(checked_int("seed", p_seed, 0, UINT32_MAX, label())));
}

void GrassFillRule::set_param(int64_t p_param, double p_value) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX(p_param, int(FILL_PARAM_COUNT));
	replace_in(*this, _rule.params[size_t(p_param)], checked(FILL_PARAMS[size_t(p_param)], p_value, label()));
}

double GrassFillRule::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(FILL_PARAM_COUNT), 0.0);
	return _rule.params[size_t(p_param)];
}

PackedStringArray GrassFillRule::find_warnings() const {
	PackedStringArray warnings;
	for (const auto &[least, most] : { std::pair(FILL_SLOPE_MIN, FILL_SLOPE_MAX), std::pair(FILL_HEIGHT_MIN, FILL_HEIGHT_MAX) }) {
		warn_if_reversed("`fill_rule`", FILL_PARAMS[least], get_param(least), FILL_PARAMS[most], get_param(most),
				"it fills little or nothing", warnings);
	}
	return warnings;
}

void GrassFillRule::set_mask(const Ref<Texture2D> &p_mask) {
	GRASS_CHANGE_GUARD(label());
	const bool had_mask = _mask.is_valid();
	if (watch_instead(_mask, p_mask, callable_mp(this, &GrassFillRule::_mask_changed))) {
		if (had_mask && !Engine::get_singleton()->is_editor_hint()) { // in a mask's place an export puts a placeholder there
			_kept_mask.unref();
		}
		_mask_changed();
	}
}

void GrassFillRule::_mask_changed() {
	_picture.reset();
	_has_told_missing = false;
	emit_changed();
}

void GrassFillRule::set_kept_mask(const Ref<Image> &p_picture) {
	GRASS_CHANGE_GUARD(label());
	if (replace(_kept_mask, p_picture)) {
		_mask_changed();
	}
}

bool GrassFillRule::is_stripped() const {
	return _mask.is_valid() && _mask->is_class("PlaceholderTexture2D");
}

Ref<Image> GrassFillRule::find_picture() const {
	const Ref<Image> picture = is_stripped() ? _kept_mask : (_mask.is_valid() ? _mask->get_image() : Ref<Image>());
	return picture.is_valid() && !picture->is_empty() ? picture : Ref<Image>();
}

GrassFillRule::MaskState GrassFillRule::get_mask_state() const {
	if (value_of(_mask).is_null()) {
		return MASK_STATE_NONE;
	}
	return find_picture().is_valid() ? MASK_STATE_READY : (is_stripped() ? MASK_STATE_MISSING : MASK_STATE_WAITING);
}

Ref<GrassFillRule> GrassFillRule::with_kept_mask() const {
	const Ref<Image> picture = find_picture();
	if (picture.is_null()) {
		return {};
	}
	Ref<GrassFillRule> copy = duplicate();
	copy->set_kept_mask(picture->duplicate()); // get_image() may return the texture's own image
	return copy;
}

void GrassFillRule::set_mask_channel(MaskChannel p_channel) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX_MSG(int64_t(p_channel), 4, label() + String(": `mask_channel` must be one of the MASK_* constants."));
	if (replace(_mask_channel, p_channel)) {
		_mask_changed();
	}
}

void GrassFillRule::set_mask_invert(bool p_invert) {
	GRASS_CHANGE_GUARD(label());
	replace_in(*this, _rule.inverts_mask, p_invert);
}

void GrassFillRule::set_mask_region(const Rect2 &p_region) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_COND_MSG(!p_region.is_finite(), label() + String(": `mask_region` must be finite."));
	replace_in(*this, _mask_region, p_region.abs());
}

void GrassFillRule::set_group(int64_t p_group, const StringName &p_name) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX(p_group, int(GROUP_COUNT));
	replace_in(*this, _groups[size_t(p_group)], p_name);
}

StringName GrassFillRule::get_group(int64_t p_group) const {
	ERR_FAIL_INDEX_V(p_group, int(GROUP_COUNT), StringName());
	return grass::value_of(_groups[size_t(p_group)]);
}

void GrassFillRule::set_texture_ids(const PackedInt32Array &p_ids) {
	GRASS_CHANGE_GUARD(label());
	std::vector<uint8_t> ids;
	for (int64_t i = 0; i < p_ids.size(); i++) {
		ERR_FAIL_COND_MSG(p_ids[i] < 0 || p_ids[i] > UINT8_MAX,
				vformat("%s: `texture_ids` must be numbers of a terrain's textures, from 0 to 255, but one is %d.", label(),
						int64_t(p_ids[i])));
		ids.push_back(uint8_t(p_ids[i]));
	}
	replace_in(*this, _rule.texture_ids, ids);
}

PackedInt32Array GrassFillRule::get_texture_ids() const {
	PackedInt32Array ids;
	for (const uint8_t id : value_of(_rule.texture_ids)) {
		ids.push_back(int32_t(id));
	}
	return ids;
}

// Returns null if there is no image: a NoiseTexture2D may still be making its own, and notifies when it is done.
std::shared_ptr<const FillMask> GrassFillRule::read_mask() const {
	String problem;
	const Ref<Image> image = read_picture(find_picture(), problem);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), nullptr, vformat("%s: the picture of `mask` %s", label(), problem));
	if (image.is_null()) {
		return nullptr;
	}
	image->convert(Image::FORMAT_RGBA8);
	const PackedByteArray bytes = image->get_data();
	FillMask mask;
	mask.width = int(image->get_width());
	mask.height = int(image->get_height());
	mask.texels.resize(size_t(mask.width) * size_t(mask.height));
	for (size_t texel = 0; texel < mask.texels.size(); texel++) { // mipmaps may follow
		mask.texels[texel] = bytes.ptr()[texel * 4 + size_t(_mask_channel)];
	}
	return std::make_shared<const FillMask>(std::move(mask));
}

FillRule GrassFillRule::get_rule(const MapRegion &p_region) {
	FillRule rule = _rule;
	if (_mask.is_valid()) {
		if (!_picture) {
			_picture = read_mask();
		}
		if (!_picture && is_stripped() && !std::exchange(_has_told_missing, true)) {
			ERR_PRINT(
					vformat("%s: the picture of `mask` was stripped by the export, so this rule grows nothing, unlike in the editor. The "
							"add-on keeps pictures of rules in scenes and files. For a picture that a script assigns, choose *Keep* in the "
							"preset's tab *Resources*; for one that the engine makes (NoiseTexture2D), save it as a file.",
							label()));
		}
		rule.has_mask = true;
		rule.mask = _picture;
		const bool is_everywhere = !_mask_region.has_area();
		rule.mask_min = is_everywhere ? p_region.min : to_eigen(_mask_region.position);
		rule.mask_max = is_everywhere ? p_region.max : to_eigen(_mask_region.get_end());
	}
	return rule;
}

void GrassFillRule::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassFillRule::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassFillRule::get_param);
	ClassDB::bind_method(D_METHOD("_set_group", "group", "name"), &GrassFillRule::set_group);
	ClassDB::bind_method(D_METHOD("_get_group", "group"), &GrassFillRule::get_group);
	const auto add_numbers = [](int p_first, int p_last) { add_params("GrassFillRule", FILL_PARAMS, p_first, p_last); };
	const auto add_group = [](const char *p_name, Group p_group) {
		ClassDB::add_property("GrassFillRule", PropertyInfo(Variant::STRING_NAME, p_name), "_set_group", "_get_group", p_group);
	};

	add_numbers(FILL_DENSITY, FILL_DENSITY);
	ADD_GROUP("Ground", "");
	add_numbers(FILL_SLOPE_MIN, FILL_HEIGHT_FADE);
	GRASS_BIND_PROPERTY(GrassFillRule, PropertyInfo(Variant::PACKED_INT32_ARRAY, "texture_ids"), set_texture_ids, get_texture_ids);
	ADD_GROUP("Noise", "");
	add_numbers(FILL_NOISE_COVER, FILL_NOISE_FADE);
	GRASS_BIND_PROPERTY(GrassFillRule, PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, "0,4294967295,1"), set_seed, get_seed);
	ADD_GROUP("Mask", "");
	GRASS_BIND_PROPERTY(GrassFillRule, PropertyInfo(Variant::OBJECT, "mask", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"), set_mask, get_mask);
	GRASS_BIND_PROPERTY(GrassFillRule, PropertyInfo(Variant::INT, "mask_channel", PROPERTY_HINT_ENUM, "Red,Green,Blue,Alpha"),
			set_mask_channel, get_mask_channel);
	GRASS_BIND_PROPERTY(GrassFillRule, PropertyInfo(Variant::BOOL, "mask_invert"), set_mask_invert, is_mask_inverted);
	GRASS_BIND_PROPERTY(
			GrassFillRule, PropertyInfo(Variant::RECT2, "mask_region", PROPERTY_HINT_NONE, "suffix:m"), set_mask_region, get_mask_region);
	GRASS_BIND_PROPERTY(GrassFillRule,
			PropertyInfo(Variant::OBJECT, "kept_mask", PROPERTY_HINT_RESOURCE_TYPE, "Image", PROPERTY_USAGE_STORAGE), set_kept_mask,
			get_kept_mask);
	ClassDB::bind_method(D_METHOD("get_mask_state"), &GrassFillRule::get_mask_state);
	add_group("mask_group", GROUP_MASK);
	ADD_GROUP("Distance", "");
	add_group("distance_group", GROUP_DISTANCE);
	add_numbers(FILL_DISTANCE, FILL_DISTANCE_FADE);
	ADD_GROUP("Exclusion", "");
	add_group("exclusion_group", GROUP_EXCLUSION);
	add_numbers(FILL_EXCLUSION_HEIGHT, FILL_EXCLUSION_FADE);

	BIND_ENUM_CONSTANT(MASK_RED);
	BIND_ENUM_CONSTANT(MASK_GREEN);
	BIND_ENUM_CONSTANT(MASK_BLUE);
	BIND_ENUM_CONSTANT(MASK_ALPHA);
	BIND_ENUM_CONSTANT(MASK_STATE_NONE);
	BIND_ENUM_CONSTANT(MASK_STATE_READY);
	BIND_ENUM_CONSTANT(MASK_STATE_WAITING);
	BIND_ENUM_CONSTANT(MASK_STATE_MISSING);
}

} // namespace grass
