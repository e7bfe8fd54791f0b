// SPDX-License-Identifier: MIT
// GrassPath3D: a path along which rules remove grass, or plant it. Draws its sides in the editor.
#pragma once

#include "core/base/tunable.h"
#include "shared/editor_picture.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/curve3d.hpp>
#include <godot_cpp/classes/path3d.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace grass {

class GrassPath3D : public godot::Path3D {
	GDCLASS(GrassPath3D, godot::Path3D)

public:
	enum Mode : int64_t { MODE_CLEAR, MODE_PLANT };

	static constexpr Tunable WIDTH{ "width", "m", 0.0, 1000.0, 0.05, 2.0 };
	static constexpr Tunable FADE{ "fade", "m", 0.0, 100.0, 0.05, 0.5 };

	GrassPath3D();

	void set_mode(Mode p_mode);
	Mode get_mode() const { return _mode; }
	void set_width(double p_width);
	double get_width() const { return _width; }
	void set_fade(double p_fade);
	double get_fade() const { return _fade; }
	void set_field_group(const godot::StringName &p_group); // fields of this group only; empty: all
	godot::StringName get_field_group() const { return value_of(_field_group); }
	void set_enabled(bool p_enabled);
	bool is_enabled() const { return _enabled; }

	// Returns the path in the node's space, as straight pieces. Empty: none.
	godot::PackedVector3Array get_points() const;
	bool concerns(const godot::Node *p_field) const;

	godot::PackedStringArray _get_configuration_warnings() const override;

	static const PicturedNodes &get_nodes() { return _nodes; }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	godot::String label() const { return label_of(*this); } // for messages
	void _changed();
	godot::Ref<godot::ArrayMesh> make_picture() const;

	Mode _mode = MODE_CLEAR;
	double _width = WIDTH.initial, _fade = FADE.initial;
	godot::StringName _field_group;
	bool _enabled = true;
	EditorPicture _picture;
	static inline PicturedNodes _nodes; // all in the tree
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassPath3D::Mode);
