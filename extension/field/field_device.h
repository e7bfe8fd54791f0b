// SPDX-License-Identifier: MIT
// Decides which device runs a field, and says why it is not the graphics device and what it cannot do there.
#pragma once

#include "draw/backend.h"
#include "field/field_properties.h"

#include <memory>

namespace grass {

// Lets worker threads prepare the passes of a first field, while the main thread makes the rest.
void begin_passes(const FieldProperties &p_properties);
// Returns the graphics device's backend if it is wanted and can run the field, otherwise the CPU's; null for a field without blades.
std::unique_ptr<Backend> make_backend(const FieldProperties &p_properties, const FieldSetup &p_setup);
// Returns the warning that the driver refused a pass, so that the CPU runs the field; empty: it refused none.
godot::String refusal_warning(const FieldProperties &p_properties, const FieldSetup &p_setup);
// Appends warnings: why the field cannot use the graphics device, or is smaller there than its properties.
void warn_of_device(const FieldProperties &p_properties, const FieldSetup &p_setup, godot::PackedStringArray &r_warnings);
godot::String crowded_warning(const FieldSetup &p_setup); // more tiles are in view than it has room for
godot::String blind_warning(); // `simulation_budget` does nothing

} // namespace grass
