// SPDX-License-Identifier: MIT
#include "resources/grass_patch.h"

#include "shared/bind_property.h"
#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/property_value.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <array>
#include <mutex>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// Of PARAM_LENGTH_MIN and those after it, up to the weights.
constexpr std::array SIZES = { std::pair(&LENGTH_MIN, &PatchParams::length_min), std::pair(&LENGTH_MAX, &PatchParams::length_max),
	std::pair(&WIDTH_MIN, &PatchParams::width_min), std::pair(&WIDTH_MAX, &PatchParams::width_max) };
static_assert(SIZES.size() == size_t(GrassPatch::PARAM_WEIGHT_UPRIGHT));

const Tunable &tunable_of(GrassPatch::Param p_param) {
	const size_t param = size_t(p_param);
	return param < SIZES.size() ? *SIZES[param].first : TYPE_WEIGHTS[param - SIZES.size()];
}

double &value_of(PatchParams &p_params, GrassPatch::Param p_param) {
	const size_t param = size_t(p_param);
	return param < SIZES.size() ? p_params.*SIZES[param].second : p_params.weights[param - SIZES.size()];
}

} // namespace

void GrassPatch::set_seed(int64_t p_seed) {
	GRASS_CHANGE_GUARD(label());
	if (replace(_params.seed, uint32_t(checked_int("seed", p_seed, 0, UINT32_MAX, label())))) {
		forget();
	}
}

void GrassPatch::set_param(Param p_param, double p_value) {
	GRASS_CHANGE_GUARD(label());
	ERR_FAIL_INDEX_MSG(int64_t(p_param), int64_t(PARAM_MAX), label() + String(": no such parameter. Use one of the PARAM_* constants."));
	if (replace(value_of(_params, p_param), checked(tunable_of(p_param), p_value, label()))) {
		forget();
	}
}

double GrassPatch::get_param(Param p_param) const {
	ERR_FAIL_INDEX_V_MSG(
			int64_t(p_param), int64_t(PARAM_MAX), 0.0, label() + String(": no such parameter. Use one of the PARAM_* constants."));
	return value_of(const_cast<PatchParams &>(_params), p_param);
}

PackedStringArray GrassPatch::find_warnings(const String &p_who) const {
	PackedStringArray warnings;
	warn_if_reversed(p_who, LENGTH_MIN, _params.length_min, LENGTH_MAX, _params.length_max, "all blades are `length_min` long", warnings);
	warn_if_reversed(p_who, WIDTH_MIN, _params.width_min, WIDTH_MAX, _params.width_max, "all blades are `width_min` wide", warnings);
	return warnings;
}

std::shared_ptr<const Patch> GrassPatch::get_patch() {
	if (!_patch) {
		if (_is_behind && !_maker.is_done()) { // the caller needs the latest
			_maker.stop();
			_is_behind = false;
		}
		prepare();
		_patch = _maker.take();
		if (_is_behind) {
			callable_mp(this, &GrassPatch::_catch_up).call_deferred();
		}
	}
	return _patch;
}

bool GrassPatch::prepare() {
	if (!_patch && !_maker.is_started()) {
		_maker.start(_params);
		_begun_in = Engine::get_singleton()->get_process_frames();
	}
	return _patch || _maker.is_done();
}

// Forgets the patch after a change. First finishes one that was begun in an earlier frame: if the parameters change in every frame, none
// would ever be ready otherwise.
void GrassPatch::forget() {
	if (_begun_in == Engine::get_singleton()->get_process_frames()) {
		_maker.stop();
	}
	_is_behind = _maker.is_started();
	_patch.reset();
	emit_changed();
}

void GrassPatch::_catch_up() {
	if (_is_behind && !_maker.is_started()) {
		forget();
	}
}

namespace {
// Kept for good, so that a game that frees its last field and makes another does not wait again.
struct DefaultPatch {
	PatchMaker maker;
	std::shared_ptr<const Patch> patch;
};
std::unique_ptr<DefaultPatch> shared_default;
std::mutex default_mutex; // scenes may be loaded on any thread
} // namespace

void GrassPatch::prepare_default() {
	std::lock_guard lock(default_mutex);
	if (!shared_default) {
		shared_default = std::make_unique<DefaultPatch>();
		shared_default->maker.start(PatchParams());
	}
}

bool GrassPatch::is_default_made() {
	prepare_default();
	std::lock_guard lock(default_mutex);
	return shared_default->patch || shared_default->maker.is_done();
}

std::shared_ptr<const Patch> GrassPatch::get_default() {
	prepare_default();
	std::lock_guard lock(default_mutex);
	if (!shared_default->patch) {
		shared_default->patch = shared_default->maker.take();
	}
	return shared_default->patch;
}

void GrassPatch::free_default() {
	shared_default.reset();
}

void GrassPatch::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_param", "param", "value"), &GrassPatch::set_param);
	ClassDB::bind_method(D_METHOD("get_param", "param"), &GrassPatch::get_param);

	GRASS_BIND_PROPERTY_AS(
			GrassPatch, PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, "0,4294967295,1"), set_seed, get_seed, "seed");
	ADD_GROUP("Size", "");
	for (int param = PARAM_LENGTH_MIN; param <= PARAM_WIDTH_MAX; param++) {
		ADD_PROPERTYI(property_of(tunable_of(Param(param))), "set_param", "get_param", param);
	}
	ADD_GROUP("Blade Types", "weight_");
	for (int param = PARAM_WEIGHT_UPRIGHT; param < PARAM_MAX; param++) {
		ADD_PROPERTYI(property_of(tunable_of(Param(param))), "set_param", "get_param", param);
	}

	BIND_ENUM_CONSTANT(PARAM_LENGTH_MIN);
	BIND_ENUM_CONSTANT(PARAM_LENGTH_MAX);
	BIND_ENUM_CONSTANT(PARAM_WIDTH_MIN);
	BIND_ENUM_CONSTANT(PARAM_WIDTH_MAX);
	BIND_ENUM_CONSTANT(PARAM_WEIGHT_UPRIGHT);
	BIND_ENUM_CONSTANT(PARAM_WEIGHT_ARCHED);
	BIND_ENUM_CONSTANT(PARAM_WEIGHT_DROOPING);
	BIND_ENUM_CONSTANT(PARAM_WEIGHT_WAVY);
	BIND_ENUM_CONSTANT(PARAM_MAX);
}

} // namespace grass
