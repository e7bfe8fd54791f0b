// SPDX-License-Identifier: MIT
// GrassPatch: the blades that a GrassField grows. Properties only; core/blades/patch.h makes the blades.
#pragma once

#include "core/blades/patch_maker.h"
#include "shared/label.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <memory>

namespace grass {

class GrassPatch : public godot::Resource {
	GDCLASS(GrassPatch, godot::Resource)

public:
	enum Param : int64_t {
		PARAM_LENGTH_MIN,
		PARAM_LENGTH_MAX,
		PARAM_WIDTH_MIN,
		PARAM_WIDTH_MAX,
		PARAM_WEIGHT_UPRIGHT,
		PARAM_WEIGHT_ARCHED,
		PARAM_WEIGHT_DROOPING,
		PARAM_WEIGHT_WAVY,
		PARAM_MAX,
	};

	void set_seed(int64_t p_seed);
	int64_t get_seed() const { return _params.seed; }
	void set_param(Param p_param, double p_value);
	double get_param(Param p_param) const;

	const PatchParams &get_params() const { return _params; }

	// Returns warnings about settings that are probably not intended. p_who: the patch's name in them.
	godot::PackedStringArray find_warnings(const godot::String &p_who) const;

	// Returns the blades. The first call after a change makes them; all fields that use this resource share them.
	std::shared_ptr<const Patch> get_patch();
	// Returns whether get_patch() returns them at once. If not, another thread begins to make them.
	bool prepare();
	// Returns the default patch, which all fields without a patch share.
	static std::shared_ptr<const Patch> get_default();
	static void prepare_default();
	static bool is_default_made(); // whether get_default() returns at once
	static void free_default(); // when the library is unloaded

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	void forget();
	void _catch_up();

	PatchParams _params;
	bool _is_behind = false; // the patch being made, or made last, has older params
	PatchMaker _maker;
	uint64_t _begun_in = 0; // the process's frame in which making it began
	std::shared_ptr<const Patch> _patch;
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassPatch::Param);
