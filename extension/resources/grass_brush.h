// SPDX-License-Identifier: MIT
// GrassBrush: what a brush does, and where it may do so. Properties only; core/paint/brush.h applies it.
#pragma once

#include "core/paint/brush.h"
#include "core/paint/brush_params.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/texture2d.hpp>

namespace grass {

class GrassBrush : public godot::Resource {
	GDCLASS(GrassBrush, godot::Resource)

public:
	// Enums that scripts set have 64 bits, so that any value from a script arrives unchanged and its setter can reject it.
	enum Tool : int64_t {
		TOOL_PAINT = int(MapTool::PAINT),
		TOOL_ERASE = int(MapTool::ERASE),
		TOOL_SMOOTH = int(MapTool::SMOOTH),
		TOOL_DENSITY = int(MapTool::DENSITY),
		TOOL_HEIGHT = int(MapTool::HEIGHT),
		TOOL_SPECIES = int(MapTool::SPECIES),
		TOOL_TINT = int(MapTool::TINT),
		TOOL_COMB = int(MapTool::COMB),
		TOOL_CUT = int(MapTool::CUT),
		TOOL_FLATTEN = int(MapTool::FLATTEN),
		TOOL_REGROW = int(MapTool::REGROW),
		TOOL_RECOVER = int(MapTool::RECOVER),
	};
	enum FalloffCurve : int64_t {
		FALLOFF_SMOOTH = int(Falloff::SMOOTH),
		FALLOFF_LINEAR = int(Falloff::LINEAR),
		FALLOFF_SPHERE = int(Falloff::SPHERE),
		FALLOFF_SHARP = int(Falloff::SHARP),
	};

	void set_tool(Tool p_tool);
	Tool get_tool() const { return _tool; }
	void set_falloff(FalloffCurve p_falloff);
	FalloffCurve get_falloff() const { return _falloff; }
	void set_stamp(const godot::Ref<godot::Texture2D> &p_stamp);
	godot::Ref<godot::Texture2D> get_stamp() const { return value_of(_stamp); }
	void set_color(const godot::Color &p_color);
	godot::Color get_color() const { return _color; }
	void set_species(int64_t p_species);
	int64_t get_species() const { return _species; }
	void set_channel(int64_t p_channel); // GrassMap::Channel
	int64_t get_channel() const { return _channel; }
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;

	// Returns the brush for a stroke from one place to another (x, z in metres).
	Brush get_brush(const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to) const;
	// Returns the shape of the stroke. A stamp is placed at the stroke's end.
	MapShape get_stroke(const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to) const {
		return get_stroke(p_from, p_to, find_turn(p_to));
	}
	MapShape get_stroke(const Eigen::Vector2d &p_from, const Eigen::Vector2d &p_to, double p_turn) const;
	// Returns the rotation of a stamp at a place, radians from x towards z. It depends on the place, so that a preview shows the result and
	// a repeated stroke leaves the same; and on the place within the chunk, so that it is the same in the space of a neighbour that is
	// whole chunks away.
	double find_turn(const Eigen::Vector2d &p_place) const;
	double get_reach() const; // from the centre of the brush to its farthest point, metres
	double get_spacing() const; // length of a stroke's steps, metres

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	void _stamp_changed(); // called when its picture changes: the engine makes some pictures later
	double param(BrushParamId p_param) const { return _params[size_t(p_param)]; }

	Tool _tool = TOOL_PAINT;
	FalloffCurve _falloff = FALLOFF_SMOOTH;
	godot::Ref<godot::Texture2D> _stamp;
	std::shared_ptr<const MapStamp> _weights; // of the stamp; null: no stamp, or its picture is not ready
	godot::Color _color = godot::Color(1, 1, 1);
	int64_t _species = 0, _channel = MAP_DENSITY;
	std::array<double, BRUSH_PARAM_COUNT> _params = initial_of(BRUSH_PARAMS);
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassBrush::Tool);
VARIANT_ENUM_CAST(grass::GrassBrush::FalloffCurve);
