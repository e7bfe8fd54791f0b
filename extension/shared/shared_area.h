// SPDX-License-Identifier: MIT
// An area of the physics server that watches boxes. Boxes side by side share one, since most of the server's work is for each area and for
// each body in it, whether anything moves or not (docs/history/0100-fields-that-rest.md).
#pragma once

#include <Eigen/Geometry>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>
#include <vector>

namespace grass {

// Returns the box around a turned one, global.
Eigen::AlignedBox3d box_around(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents);

class SharedArea : public godot::RefCounted {
	GDCLASS(SharedArea, godot::RefCounted)

public:
	struct Kind {
		godot::RID space;
		uint32_t mask = 0;
		bool sees_areas = false;
		bool operator==(const Kind &) const = default;
	};
	// Called with the arguments of PhysicsServer3D.area_set_monitor_callback, and of area_set_area_monitor_callback.
	struct Listener {
		godot::Callable changed, area_changed;
	};

	~SharedArea();

	// Returns the area that a box may join, or a new one.
	static godot::Ref<SharedArea> find(const Kind &p_kind, const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents);
	static godot::Ref<SharedArea> make(const Kind &p_kind, const godot::Transform3D &p_transform);
	static int64_t get_count(); // of all areas

	// Adds a box, and returns its index.
	int add(const godot::Transform3D &p_transform, const godot::Vector3 &p_half_extents, const Listener &p_listener);
	// Removes a box. p_tells: its listener is still told which bodies leave it, even if nobody else uses the area.
	void remove(int p_box, bool p_tells);
	// Moves the only box. Others do not join it any more.
	void move(int p_box, const godot::Transform3D &p_transform);
	void resize(int p_box, const godot::Vector3 &p_half_extents);
	bool is_shared() const { return _used > 1; }

protected:
	static void _bind_methods() {}

private:
	struct Box {
		godot::RID shape;
		godot::Transform3D local; // in the area
		godot::Vector3 half_extents;
		Listener listener;
		bool is_used = true, is_told = false; // is_told: the listener of a box that is no longer used hears which bodies leave
		int64_t overlaps = 0; // that the server has reported
	};

	void start(const Kind &p_kind, const godot::Transform3D &p_transform);
	bool has_room(const Eigen::AlignedBox3d &p_box) const;
	Eigen::AlignedBox3d find_bounds(double &r_volume) const;
	bool has_to_tell() const;
	void _let_go();
	Listener count(int64_t p_status, int64_t p_box);
	void _changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_box);
	void _area_changed(int64_t p_status, const godot::RID &p_area, int64_t p_instance_id, int64_t p_area_shape, int64_t p_box);

	uint64_t _id = 0;
	godot::Ref<SharedArea> _self; // keeps the area alive while it has bodies to report
	Kind _kind;
	godot::RID _area;
	godot::Transform3D _place;
	std::vector<Box> _boxes;
	int _used = 0;
	bool _has_moved = false;
};

} // namespace grass
