// SPDX-License-Identifier: MIT
// A field as a value, for a record that is played without the scene: everything that its blades and their motion depend on, but nothing
// that is only drawn.
#pragma once

#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

class GrassField;

godot::Dictionary describe_field(const GrassField &p_field);
// Makes the field what p_described says. Returns "", or why that is impossible, as the end of a sentence that begins with the file's name.
godot::String become_described(GrassField &r_field, const godot::Dictionary &p_described);

} // namespace grass
