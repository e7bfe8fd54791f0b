// SPDX-License-Identifier: MIT
// Answers "why is there no grass here?", for scripts and the editor.
#pragma once

#include "field/standing_field.h"
#include "ground/field_filler.h"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <array>

namespace grass {

enum class BareReason : int64_t {
	NONE,
	NOT_MADE,
	HIDDEN,
	OUTSIDE,
	LAYERS,
	TOO_FAR,
	NO_ROOM,
	MAP,
	PAINTED,
	FILL_DENSITY,
	FILL_MASK,
	FILL_MESH,
	FILL_SLOPE,
	FILL_HEIGHT,
	FILL_NOISE,
	FILL_NODE,
	WORN,
	SHORT,
	CUT,
	HOLE,
	FILL_TEXTURE,
	LEDGE,
	LEVEL,
};

// What scripts call them, in the same order: GrassField.Reason.
inline constexpr std::array BARE_REASONS = { "REASON_NONE", "REASON_NOT_MADE", "REASON_HIDDEN", "REASON_OUTSIDE", "REASON_LAYERS",
	"REASON_TOO_FAR", "REASON_NO_ROOM", "REASON_MAP", "REASON_PAINTED", "REASON_FILL_DENSITY", "REASON_FILL_MASK", "REASON_FILL_MESH",
	"REASON_FILL_SLOPE", "REASON_FILL_HEIGHT", "REASON_FILL_NOISE", "REASON_FILL_NODE", "REASON_WORN", "REASON_SHORT", "REASON_CUT",
	"REASON_HOLE", "REASON_FILL_TEXTURE", "REASON_LEDGE", "REASON_LEVEL" };
static_assert(BARE_REASONS.size() == size_t(BareReason::LEVEL) + 1);

struct BareAnswer {
	BareReason reason = BareReason::NONE;
	godot::String text; // one or two sentences
	godot::Node3D *node = nullptr; // FILL_NODE: what keeps grass away; LEVEL: the field whose level it is
	double density = 0.0, height = 0.0; // of the grass at the place: share, metres
	bool is_still = false; // nothing can bend it: the pool is full, or the field is not simulated
};

// Explains a place. p_place: global. p_camera: null: for no particular camera. p_other: another field whose ground is there, or null.
BareAnswer explain_place(const godot::GeometryInstance3D &p_node, const StandingField &p_standing, FieldFiller &r_filler,
		const FieldProperties &p_properties, const FieldFiller::Place &p_fill, const godot::Vector3 &p_place,
		const godot::Camera3D *p_camera, godot::Node3D *p_other);
godot::Dictionary to_dictionary(const BareAnswer &p_answer);

} // namespace grass
