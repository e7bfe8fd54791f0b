// SPDX-License-Identifier: MIT
// GrassForce3D: moves the air around it, and so all grass there: a blast, a rotor's downwash, a vortex, or local wind.
#pragma once

#include "core/blades/force.h"
#include "shared/editor_picture.h"
#include "shared/label.h"

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace grass {

class GrassForce3D : public godot::Node3D {
	GDCLASS(GrassForce3D, godot::Node3D)

public:
	enum Kind : int64_t {
		KIND_BLAST = int(ForceKind::BLAST),
		KIND_DOWNWASH = int(ForceKind::DOWNWASH),
		KIND_VORTEX = int(ForceKind::VORTEX),
		KIND_WIND = int(ForceKind::WIND), // blows along the node's -z
	};

	void set_kind(Kind p_kind);
	Kind get_kind() const { return Kind(_force.kind); }
	void set_speed(double p_speed);
	double get_speed() const { return _force.speed; }
	void set_radius(double p_radius);
	double get_radius() const { return _force.radius; }
	void set_duration(double p_duration);
	double get_duration() const { return _duration; }
	void set_turbulence(double p_turbulence);
	double get_turbulence() const { return _force.turbulence; }
	void set_enabled(bool p_enabled);
	bool is_enabled() const { return _enabled; }

	void fire(); // starts a blast from its beginning
	bool is_blowing() const;

	godot::PackedStringArray _get_configuration_warnings() const override;

	// Returns those in the tree that blow, in the order of their creation.
	static std::vector<GrassForce3D *> get_blowing();
	static bool is_any_in_tree() { return !_nodes.is_empty(); }
	Force get_force(); // in global space; in a rendered frame as drawn

protected:
	static void _bind_methods();
	void _notification(int p_what);
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	void update_picture();
	godot::String label() const { return label_of(*this); } // for messages

	Force _force; // its place and direction are the node's
	double _duration = FORCE_DURATION.initial;
	bool _enabled = true;
	bool _is_fired = false; // a blast has begun and is not over
	EditorPicture _picture;
	static inline PicturedNodes _nodes; // all in the tree
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassForce3D::Kind);
