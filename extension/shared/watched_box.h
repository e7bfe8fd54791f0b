// SPDX-License-Identifier: MIT
// A box in the physics server, which reports the bodies and areas that enter and leave it.
#pragma once

#include "shared/shared_area.h"

#include <cstdint>

namespace grass {

class WatchedBox {
public:
	// Starts to watch, from the first place() on. p_changed, p_area_changed: called with the five arguments of
	// PhysicsServer3D.area_set_monitor_callback; without p_area_changed areas are not watched, and no area is shared with other boxes.
	void start(const godot::RID &p_space, uint32_t p_mask, const godot::Callable &p_changed,
			const godot::Callable &p_area_changed = godot::Callable());
	void stop();
	// Places the box; p_half_extents: metres. These do nothing before start().
	void place(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents);
	void set_mask(uint32_t p_mask);
	const godot::Vector3 &get_half_extents() const { return _half_extents; } // metres

private:
	void join(const godot::Ref<SharedArea> &p_area);
	void leave(bool p_tells);

	SharedArea::Kind _kind;
	SharedArea::Listener _listener;
	godot::Ref<SharedArea> _area; // null: not placed yet
	int _box = 0; // of it
	godot::Transform3D _transform;
	godot::Vector3 _half_extents;
};

} // namespace grass
