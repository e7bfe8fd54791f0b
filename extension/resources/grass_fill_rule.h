// SPDX-License-Identifier: MIT
// GrassFillRule: where grass grows by itself. Properties only; core/fill/fill.h fills, ground/fill_gatherer.h finds the nodes
// that its groups name.
#pragma once

#include "core/fill/fill.h"
#include "shared/label.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/rect2.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace grass {

class GrassFillRule : public godot::Resource {
	GDCLASS(GrassFillRule, godot::Resource)

public:
	enum MaskChannel : int64_t { MASK_RED, MASK_GREEN, MASK_BLUE, MASK_ALPHA };
	enum MaskState : int64_t { MASK_NONE, MASK_READY, MASK_WAITING, MASK_MISSING };
	enum Group { GROUP_MASK, GROUP_DISTANCE, GROUP_EXCLUSION, GROUP_COUNT };

	GrassFillRule();

	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return int64_t(_rule.seed); }
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	void set_mask(const godot::Ref<godot::Texture2D> &p_mask);
	godot::Ref<godot::Texture2D> get_mask() const { return value_of(_mask); }
	// Of `mask`: what an export for a server puts into the rule, since it leaves pictures out. Null: none.
	void set_kept_mask(const godot::Ref<godot::Image> &p_picture);
	godot::Ref<godot::Image> get_kept_mask() const { return value_of(_kept_mask); }
	// Not made yet, or never there, are two things.
	MaskState get_mask_state() const;
	// A copy of the rule that keeps the picture of its mask; null where it has none. For an export.
	godot::Ref<GrassFillRule> with_kept_mask() const;
	void set_mask_channel(MaskChannel p_channel);
	MaskChannel get_mask_channel() const { return _mask_channel; }
	void set_mask_invert(bool p_invert);
	bool is_mask_inverted() const { return _rule.inverts_mask; }
	void set_mask_region(const godot::Rect2 &p_region); // x, z in metres; empty: all that is filled
	godot::Rect2 get_mask_region() const { return _mask_region; }
	void set_group(int64_t p_group, const godot::StringName &p_name);
	godot::StringName get_group(int64_t p_group) const;

	void set_texture_ids(const godot::PackedInt32Array &p_ids); // of the field's terrain; empty: all
	godot::PackedInt32Array get_texture_ids() const;

	godot::PackedStringArray find_warnings() const; // about settings that are hardly intended
	bool asks_textures() const { return _rule.asks_textures(); }
	bool asks_ground() const { return _rule.asks_slope() || _rule.asks_height(); }
	// p_region: what is filled.
	FillRule get_rule(const MapRegion &p_region);

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	void _mask_changed();
	std::shared_ptr<const FillMask> read_mask() const;
	godot::Ref<godot::Image> find_picture() const; // of the mask; null: none
	bool is_stripped() const; // an export put something else in the mask's place

	FillRule _rule; // but for its mask
	godot::Ref<godot::Texture2D> _mask;
	godot::Ref<godot::Image> _kept_mask;
	bool _has_told_missing = false; // since the mask changed
	MaskChannel _mask_channel = MASK_RED;
	godot::Rect2 _mask_region;
	std::shared_ptr<const FillMask> _picture; // of _mask; null: not read since it changed, or not made yet
	std::array<godot::StringName, GROUP_COUNT> _groups;
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassFillRule::MaskChannel);
VARIANT_ENUM_CAST(grass::GrassFillRule::MaskState);
