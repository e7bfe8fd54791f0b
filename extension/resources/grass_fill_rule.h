// SPDX-License-Identifier: MIT
// GrassFillRule: where grass grows automatically. Properties only; core/fill/fill.h fills, and ground/fill_gatherer.h finds the nodes of
// its groups.
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
	enum MaskState : int64_t { MASK_STATE_NONE, MASK_STATE_READY, MASK_STATE_WAITING, MASK_STATE_MISSING };
	enum Group { GROUP_MASK, GROUP_DISTANCE, GROUP_EXCLUSION, GROUP_COUNT };

	GrassFillRule();

	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return int64_t(_rule.seed); }
	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	void set_mask(const godot::Ref<godot::Texture2D> &p_mask);
	godot::Ref<godot::Texture2D> get_mask() const { return value_of(_mask); }
	// Sets the picture of `mask` that an export for a server puts into the rule, since such an export leaves pictures out. Null: none.
	void set_kept_mask(const godot::Ref<godot::Image> &p_picture);
	godot::Ref<godot::Image> get_kept_mask() const { return value_of(_kept_mask); }
	// Returns the state, which distinguishes a picture that is not made yet from one that is missing.
	MaskState get_mask_state() const;
	// Returns a copy of the rule that stores the picture of its mask, for an export; null if it has none.
	godot::Ref<GrassFillRule> with_kept_mask() const;
	void set_mask_channel(MaskChannel p_channel);
	MaskChannel get_mask_channel() const { return _mask_channel; }
	void set_mask_invert(bool p_invert);
	bool is_mask_inverted() const { return _rule.inverts_mask; }
	void set_mask_region(const godot::Rect2 &p_region); // x, z in metres; empty: the whole filled area
	godot::Rect2 get_mask_region() const { return _mask_region; }
	void set_group(int64_t p_group, const godot::StringName &p_name);
	godot::StringName get_group(int64_t p_group) const;

	void set_texture_ids(const godot::PackedInt32Array &p_ids); // of the field's terrain; empty: all
	godot::PackedInt32Array get_texture_ids() const;

	godot::PackedStringArray find_warnings() const; // about settings that are probably not intended
	bool asks_textures() const { return _rule.asks_textures(); }
	bool asks_ground() const { return _rule.asks_slope() || _rule.asks_height(); }
	// Returns the rule as the core reads it. p_region: the area to fill.
	FillRule get_rule(const MapRegion &p_region);

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	void _mask_changed();
	std::shared_ptr<const FillMask> read_mask() const;
	godot::Ref<godot::Image> find_picture() const; // of the mask; null: none
	bool is_stripped() const; // an export replaced the mask's picture

	FillRule _rule; // without its mask
	godot::Ref<godot::Texture2D> _mask;
	godot::Ref<godot::Image> _kept_mask;
	bool _has_told_missing = false; // since the mask changed
	MaskChannel _mask_channel = MASK_RED;
	godot::Rect2 _mask_region;
	std::shared_ptr<const FillMask> _picture; // of _mask; null: not read since it changed, or not ready yet
	std::array<godot::StringName, GROUP_COUNT> _groups;
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassFillRule::MaskChannel);
VARIANT_ENUM_CAST(grass::GrassFillRule::MaskState);
