// SPDX-License-Identifier: MIT
// GrassBoneColliders3D: lets a skeleton without physics bend grass, by a capsule along each of its bones.
#pragma once

#include "core/base/tunable.h"
#include "nodes/label.h"
#include "nodes/property_value.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <vector>

namespace grass {

class GrassBoneColliders3D : public godot::Node3D {
	GDCLASS(GrassBoneColliders3D, godot::Node3D)

public:
	// Of a capsule: share of its bone's length. Arms and legs of people 0.1 to 0.2.
	static constexpr Tunable THICKNESS{ "thickness", "", 0.01, 1.0, 0.01, 0.15 };
	// Shorter bones, fingers for instance, bend no grass: each costs what a body's shape costs.
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
	void set_enabled(bool p_enabled) { _enabled = p_enabled; }
	bool is_enabled() const { return _enabled; }

	godot::PackedStringArray _get_configuration_warnings() const override;

	// Those in the tree that are enabled, in the order in which they were made.
	static std::vector<const GrassBoneColliders3D *> get_all();
	std::vector<Bone> find_bones() const; // as the skeleton stands now

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	godot::String label() const { return label_of(*this); } // for messages
	const godot::Skeleton3D *find_skeleton() const;

	godot::NodePath _skeleton;
	godot::PackedStringArray _bones;
	double _thickness = THICKNESS.initial;
	double _length_min = LENGTH_MIN.initial;
	bool _enabled = true;
};

} // namespace grass
