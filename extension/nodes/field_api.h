// SPDX-License-Identifier: MIT
// Binds what scripts and the inspector see of GrassField: its properties, methods, signals and constants, each to the part that it belongs
// to.
#pragma once

#include "nodes/grass_field.h"

namespace grass {

struct FieldApi {
	static void bind(); // in GrassField::_bind_methods()

private:
	static void bind_properties();
	static void bind_look();
	static void bind_queries();
	static void bind_deeds();
	static void bind_signals();
	static void bind_constants();
	static const godot::StringName &get_class_static() { return GrassField::get_class_static(); } // for the engine's macros

	// The parts that methods are bound to.
	static constexpr PartBinder<GrassField, &GrassField::_parts, &FieldParts::settings> settings{};
	static constexpr PartBinder<GrassField, &GrassField::_parts, &FieldParts::sources> sources{};
	static constexpr PartBinder<GrassField, &GrassField::_parts, &FieldParts::queries> queries{};
	static constexpr PartBinder<GrassField, &GrassField::_parts, &FieldParts::work> work{};
	static constexpr PartBinder<GrassField, &GrassField::_parts, &FieldParts::forces> forces{};
	static constexpr PartBinder<GrassField, &GrassField::_ticks> ticks{};
	static constexpr PartBinder<GrassField, &GrassField::_ticks, &FieldTicks::_record> record{};
	static constexpr PartBinder<GrassField, &GrassField::_report> report{};
};

} // namespace grass
