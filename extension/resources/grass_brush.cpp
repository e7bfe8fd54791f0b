// SPDX-License-Identifier: MIT
#include "resources/grass_brush.h"

#include "core/base/hash.h"
#include "core/paint/stroke_path.h"
#include "shared/bind_property.h"
#include "shared/params.h"
#include "shared/picture.h"
#include "shared/watch_resource.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <cmath>
#include <numbers>

using namespace godot;

namespace grass {

void GrassBrush::set_tool(Tool p_tool) {
	ERR_FAIL_INDEX_MSG(int64_t(p_tool), int64_t(MapTool::COUNT), label() + String(": `tool` must be one of the TOOL_* constants."));
	replace_in(*this, _tool, p_tool);
}

void GrassBrush::set_falloff(FalloffCurve p_falloff) {
	ERR_FAIL_INDEX_MSG(int64_t(p_falloff), 4, label() + String(": `falloff` must be one of the FALLOFF_* constants."));
	replace_in(*this, _falloff, p_falloff);
}

void GrassBrush::set_stamp(const Ref<Texture2D> &p_stamp) {
	if (watch_instead(_stamp, p_stamp, callable_mp(this, &GrassBrush::_stamp_changed))) {
		_stamp_changed();
	}
}

void GrassBrush::_stamp_changed() {
	_weights.reset();
	String problem;
	const Ref<Image> image = read_picture(_stamp.is_valid() ? _stamp->get_image() : Ref<Image>(), problem);
	if (!problem.is_empty()) {
		ERR_PRINT(vformat("%s: the picture of `stamp` %s", label(), problem));
	}
	if (image.is_valid()) {
		const int64_t most = std::max(image->get_width(), image->get_height());
		if (most > MapStamp::MOST) {
			const auto fit = [&](int64_t p_size) { return int32_t(std::max<int64_t>(p_size * MapStamp::MOST / most, 1)); };
			image->resize(fit(image->get_width()), fit(image->get_height()), Image::INTERPOLATE_LANCZOS);
		}
		const int width = image->get_width(), height = image->get_height();
		std::vector<float> weights;
		weights.reserve(size_t(width) * size_t(height));
		for (int y = 0; y < height; y++) {
			for (int x = 0; x < width; x++) {
				const Color color = image->get_pixel(x, y);
				weights.push_back((0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b) * color.a); // luminance
			}
		}
		_weights = std::make_shared<const MapStamp>(width, height, std::move(weights));
	}
	emit_changed();
}

void GrassBrush::set_color(const Color &p_color) {
	replace_in(*this, _color, p_color);
}

void GrassBrush::set_species(int64_t p_species) {
	replace_in(*this, _species, checked_int("species", p_species, 0, info_of(MAP_SPECIES).highest, label()));
}

void GrassBrush::set_channel(int64_t p_channel) {
	ERR_FAIL_INDEX_MSG(p_channel, int64_t(MAP_CHANNELS), label() + String(": `channel` must be one of GrassMap's CHANNEL_* constants."));
	ERR_FAIL_COND_MSG(p_channel == MAP_PAINT, label() + String(": smooth the density instead, and the painted mask follows."));
	ERR_FAIL_COND_MSG(!info_of(MapChannel(p_channel)).blends,
			label() + String(": species cannot be smoothed, since there is no mean of two species."));
	replace_in(*this, _channel, p_channel);
}

void GrassBrush::set_param(int64_t p_param, double p_value) {
	ERR_FAIL_INDEX(p_param, int(BRUSH_PARAM_COUNT));
	replace_in(*this, _params[size_t(p_param)], checked(BRUSH_PARAMS[size_t(p_param)], p_value, label()));
}

double GrassBrush::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int(BRUSH_PARAM_COUNT), 0.0);
	return _params[size_t(p_param)];
}

Brush GrassBrush::get_brush(const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to) const {
	Brush brush;
	brush.tool = MapTool(_tool);
	brush.strength = param(BRUSH_STRENGTH);
	brush.target = param(BRUSH_TARGET);
	if (_tool == TOOL_CUT || _tool == TOOL_REGROW) {
		brush.target = param(BRUSH_CUT_HEIGHT);
	} else if (_tool == TOOL_SPECIES) {
		brush.target = double(_species);
	}
	brush.color = { _color.r, _color.g, _color.b };
	brush.direction = p_to - p_from;
	brush.channel = MapChannel(_channel);
	brush.limits = { param(BRUSH_SLOPE_MIN), param(BRUSH_SLOPE_MAX), param(BRUSH_HEIGHT_MIN), param(BRUSH_HEIGHT_MAX) };
	return brush;
}

MapShape GrassBrush::get_stroke(const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to, double p_turn) const {
	if (_stamp.is_null()) {
		return MapShape::stroke(p_from, p_to, param(BRUSH_RADIUS), param(BRUSH_HARDNESS), Falloff(_falloff));
	}
	return _weights == nullptr ? MapShape() : MapShape::stamped(p_to, param(BRUSH_RADIUS), p_turn, _weights);
}

double GrassBrush::find_turn(const Eigen::Vector2d &p_place) const {
	const auto centimetre = [](double p_metres) {
		return uint32_t(100.0 * (p_metres - MAP_CHUNK_SIZE * std::floor(p_metres / MAP_CHUNK_SIZE)));
	};
	const bool is_finite = p_place.allFinite();
	const uint32_t bits = is_finite ? grass_hash(centimetre(p_place.x()) ^ grass_hash(centimetre(p_place.y()))) : 0;
	return (param(BRUSH_STAMP_ROTATION) + param(BRUSH_STAMP_RANDOM) * double(bits) / 4294967296.0) * (std::numbers::pi / 180.0);
}

double GrassBrush::get_reach() const {
	return param(BRUSH_RADIUS) * (_stamp.is_null() ? 1.0 : std::numbers::sqrt2); // a stamp has corners
}

double GrassBrush::get_spacing() const {
	return param(BRUSH_RADIUS) * (_stamp.is_null() ? StrokePath::SPACING : 2.0); // stamps are placed side by side
}

void GrassBrush::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassBrush::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassBrush::get_param);
	const auto add_numbers = [](int p_first, int p_last) { add_params("GrassBrush", BRUSH_PARAMS, p_first, p_last); };

	GRASS_BIND_PROPERTY(GrassBrush,
			PropertyInfo(Variant::INT, "tool", PROPERTY_HINT_ENUM,
					"Paint,Erase,Smooth,Density,Height,Species,Tint,Comb,Cut,Flatten,Regrow,Recover"),
			set_tool, get_tool);
	add_numbers(BRUSH_RADIUS, BRUSH_HARDNESS);
	GRASS_BIND_PROPERTY(
			GrassBrush, PropertyInfo(Variant::INT, "falloff", PROPERTY_HINT_ENUM, "Smooth,Linear,Sphere,Sharp"), set_falloff, get_falloff);
	GRASS_BIND_PROPERTY(GrassBrush, PropertyInfo(Variant::OBJECT, "stamp", PROPERTY_HINT_RESOURCE_TYPE, "Texture2D"), set_stamp, get_stamp);
	add_numbers(BRUSH_STAMP_ROTATION, BRUSH_STAMP_RANDOM);
	add_numbers(BRUSH_TARGET, BRUSH_CUT_HEIGHT);
	GRASS_BIND_PROPERTY(GrassBrush, PropertyInfo(Variant::INT, "species", PROPERTY_HINT_RANGE, "0,255,1"), set_species, get_species);
	GRASS_BIND_PROPERTY(GrassBrush, PropertyInfo(Variant::COLOR, "color", PROPERTY_HINT_COLOR_NO_ALPHA), set_color, get_color);
	GRASS_BIND_PROPERTY(GrassBrush,
			PropertyInfo(Variant::INT, "channel", PROPERTY_HINT_ENUM, "Density:0,Height:1,Tint:3,Lean:4,Ground:5,Normal:6,Wear:7,Cut:8"),
			set_channel, get_channel);
	ADD_GROUP("Limits", "");
	add_numbers(BRUSH_SLOPE_MIN, BRUSH_HEIGHT_MAX);

	BIND_ENUM_CONSTANT(TOOL_PAINT);
	BIND_ENUM_CONSTANT(TOOL_ERASE);
	BIND_ENUM_CONSTANT(TOOL_SMOOTH);
	BIND_ENUM_CONSTANT(TOOL_DENSITY);
	BIND_ENUM_CONSTANT(TOOL_HEIGHT);
	BIND_ENUM_CONSTANT(TOOL_SPECIES);
	BIND_ENUM_CONSTANT(TOOL_TINT);
	BIND_ENUM_CONSTANT(TOOL_COMB);
	BIND_ENUM_CONSTANT(TOOL_CUT);
	BIND_ENUM_CONSTANT(TOOL_FLATTEN);
	BIND_ENUM_CONSTANT(TOOL_REGROW);
	BIND_ENUM_CONSTANT(TOOL_RECOVER);
	BIND_ENUM_CONSTANT(FALLOFF_SMOOTH);
	BIND_ENUM_CONSTANT(FALLOFF_LINEAR);
	BIND_ENUM_CONSTANT(FALLOFF_SPHERE);
	BIND_ENUM_CONSTANT(FALLOFF_SHARP);
}

} // namespace grass
