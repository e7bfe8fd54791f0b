// SPDX-License-Identifier: MIT
// GrassExclusion3D: keeps what rules fill away from a shape. Draws itself in the editor.
#pragma once

#include "core/base/tunable.h"
#include "shared/editor_picture.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

namespace grass {

class GrassExclusion3D : public godot::Node3D {
	GDCLASS(GrassExclusion3D, godot::Node3D)

public:
	static constexpr Tunable FADE{ "fade", "m", 0.0, 100.0, 0.05, 0.25 };

	void set_shape(const godot::Ref<godot::Shape3D> &p_shape);
	godot::Ref<godot::Shape3D> get_shape() const { return value_of(_shape); }
	void set_outline(const godot::PackedVector2Array &p_outline); // x, z in metres; used if there is no shape
	godot::PackedVector2Array get_outline() const { return value_of(_outline); }
	void set_fade(double p_fade);
	double get_fade() const { return _fade; }
	void set_enabled(bool p_enabled);
	bool is_enabled() const { return _enabled; }

	godot::PackedStringArray _get_configuration_warnings() const override;

	static const PicturedNodes &get_nodes() { return _nodes; }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	godot::String label() const { return label_of(*this); } // for messages
	void changed();
	godot::Ref<godot::ArrayMesh> make_picture() const;

	godot::Ref<godot::Shape3D> _shape;
	godot::PackedVector2Array _outline;
	double _fade = FADE.initial;
	bool _enabled = true;
	EditorPicture _picture;
	static inline PicturedNodes _nodes; // all in the tree
};

} // namespace grass
