// SPDX-License-Identifier: MIT
// GrassBoneColliders3D: lets a skeleton without physics bend grass, with a capsule along each of its bones.
#pragma once

#include "core/base/tunable.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <Eigen/Geometry>

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <limits>
#include <map>
#include <vector>

namespace grass {

class GrassBoneColliders3D : public godot::Node3D {
	GDCLASS(GrassBoneColliders3D, godot::Node3D)

public:
	// Radius of a capsule, as a share of its bone's length. Arms and legs of people: 0.1 to 0.2.
	static constexpr Tunable THICKNESS{ "thickness", "", 0.01, 1.0, 0.01, 0.15 };
	// Shorter bones, such as fingers, bend no grass, since each costs as much as a body's shape.
	static constexpr Tunable LENGTH_MIN{ "length_min", "m", 0.0, 10.0, 0.01, 0.1 };

	// The capsule along one bone, global.
	struct Bone {
		int index; // in the skeleton
		godot::Vector3 from, to; // its ends, metres
		double radius; // metres
	};

	void set_skeleton(const godot::NodePath &p_skeleton);
	godot::NodePath get_skeleton() const { return value_of(_skeleton); }
	void set_bones(const godot::PackedStringArray &p_bones); // names; none: all
	godot::PackedStringArray get_bones() const { return value_of(_bones); }
	void set_thickness(double p_thickness);
	double get_thickness() const { return _thickness; }
	void set_length_min(double p_length);
	double get_length_min() const { return _length_min; }
	void set_enabled(bool p_enabled) {
		_enabled = p_enabled;
		forget();
	}
	bool is_enabled() const { return _enabled; }

	godot::PackedStringArray _get_configuration_warnings() const override;

	// Returns all nodes in the tree, in the order of their creation.
	static const std::map<uint64_t, GrassBoneColliders3D *> &get_all();
	// Returns a global box around its bones, sometimes some metres too large: the bones are read in every eighth tick, and the skeleton's
	// place in every tick. All fields share what is read in a tick, and r_calls counts it once. Empty: it has no bones.
	Eigen::AlignedBox3d find_bounds(int64_t &r_calls);
	// Returns the bones as the skeleton is posed in this tick.
	const std::vector<Bone> &find_bones(int64_t &r_calls);
	const godot::Ref<godot::World3D> &get_world() const { return _world; }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	godot::String label() const { return label_of(*this); } // for messages
	const godot::Skeleton3D *find_skeleton() const;
	const godot::Skeleton3D *see(int64_t &r_calls);
	void read_bones(const godot::Skeleton3D &p_skeleton, int64_t &r_calls);
	bool has_bone(const godot::Skeleton3D &p_skeleton, int p_bone, int64_t &r_calls) const;
	void forget() { _seen = Seen(); }

	godot::NodePath _skeleton;
	godot::PackedStringArray _bones;
	double _thickness = THICKNESS.initial;
	double _length_min = LENGTH_MIN.initial;
	bool _enabled = true;

	static constexpr uint64_t NEVER = std::numeric_limits<uint64_t>::max();
	// What is known about the skeleton, and from which tick of the engine.
	struct Seen {
		uint64_t tick = NEVER, bones_tick = NEVER;
		uint64_t skeleton = 0; // instance id, in that tick; 0: none
		godot::Transform3D to_world;
		double way = 0.0; // distance that it moved since the tick before, metres
		Eigen::AlignedBox3d box; // of the bones, in the skeleton
		std::vector<Bone> bones;
	};
	Seen _seen;
	godot::Ref<godot::World3D> _world; // while it is in the tree
};

} // namespace grass
