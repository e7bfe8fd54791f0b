// SPDX-License-Identifier: MIT
// A box in the physics server, which reports the bodies and areas that enter and leave it.
#pragma once

#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>

namespace grass {

class WatchedBox {
public:
	// Starts to watch, in a box without extent. p_changed, p_area_changed: called with the five arguments of
	// PhysicsServer3D.area_set_monitor_callback; without p_area_changed areas are not watched.
	void start(const godot::RID &p_space, uint32_t p_mask, const godot::Callable &p_changed,
			const godot::Callable &p_area_changed = godot::Callable());
	void stop();
	bool is_watching() const { return _area.is_valid(); }
	// Places the box; p_half_extents: metres. These do nothing while nothing is watched.
	void place(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents);
	void set_mask(uint32_t p_mask);
	const godot::Vector3 &get_half_extents() const { return _half_extents; } // metres

private:
	godot::RID _area, _shape;
	godot::Transform3D _transform;
	godot::Vector3 _half_extents;
};

} // namespace grass
