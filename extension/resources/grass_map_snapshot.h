// SPDX-License-Identifier: MIT
#pragma once

#include "core/map/paint_map.h"

#include <godot_cpp/classes/ref_counted.hpp>

namespace grass {

// The whole map at one moment. Costs a pointer for each channel and chunk until one of the two changes.
class GrassMapSnapshot : public godot::RefCounted {
	GDCLASS(GrassMapSnapshot, godot::RefCounted)

public:
	PaintMap map;

protected:
	static void _bind_methods() {}
};

} // namespace grass
