// SPDX-License-Identifier: MIT
#include "gpu/compile_queue.h"

#include "gpu/device.h"

#include <godot_cpp/classes/rd_pipeline_specialization_constant.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <algorithm>
#include <cstddef>

using namespace godot;

namespace grass {

namespace {

TypedArray<Ref<RDPipelineSpecializationConstant>> constants_of(const PassCode &p_code) {
	TypedArray<Ref<RDPipelineSpecializationConstant>> constants;
	const auto add = [&](int p_id, const Variant &p_value) {
		Ref<RDPipelineSpecializationConstant> constant;
		constant.instantiate();
		constant->set_constant_id(uint32_t(p_id));
		constant->set_value(p_value);
		constants.push_back(constant);
	};
	if (p_code.method != PassCode::NO_METHOD) {
		add(GRASS_CONSTANT_METHOD, p_code.method);
		add(GRASS_CONSTANT_TILES, p_code.tiles);
		add(GRASS_CONSTANT_OWN_WORK, p_code.own_work);
	}
	return constants;
}

const char *origin_of(PassShaders::From p_from) {
	return p_from == PassShaders::From::FILE ? "read" : p_from == PassShaders::From::CODE ? "translated" : "known";
}

} // namespace

CompileQueue &CompileQueue::get() {
	static CompileQueue queue;
	return queue;
}

CompileQueue::Pipeline &CompileQueue::find(const PassCode &p_code, Need p_need) {
	std::unique_lock lock(_mutex);
	const auto [found, is_new] = _pipelines.try_emplace(p_code.key(), p_code);
	lock.unlock();
	Pipeline &pipeline = found->second;
	if (is_new) {
		_compiling++;
		_deciding += p_code.changes_results() ? 1 : 0;
		_queue.push(
				&pipeline, [this, &pipeline] { compile(pipeline, true); }, int(p_code.order), p_need);
	} else if (p_need == Need::WANTED) {
		_queue.want(&pipeline);
	}
	return pipeline;
}

void CompileQueue::compile(Pipeline &r_pipeline, bool p_is_worker) {
	const bool is_left_out = is_useless(r_pipeline.code);
	if (!is_left_out) {
		make(r_pipeline, p_is_worker);
	}
	std::lock_guard lock(_mutex);
	if (!is_left_out && !r_pipeline.pipeline.is_valid()) {
		_refused.push_back(r_pipeline.code);
		_refused_count++;
	}
	r_pipeline.is_done = true;
	_compiling--;
	_deciding -= r_pipeline.code.changes_results() ? 1 : 0;
	_has_compiled.notify_all();
}

void CompileQueue::make(Pipeline &r_pipeline, bool p_is_worker) {
	UtilityFunctions::print_verbose(vformat("GrassField: compiling '%s'", r_pipeline.code.name));
	const uint64_t begin = Time::get_singleton()->get_ticks_msec();
	PassShaders::Made made = _shaders.make(r_pipeline.code, p_is_worker);
	const uint64_t has_shader = Time::get_singleton()->get_ticks_msec();
	r_pipeline.make(made.shader);
	if (!r_pipeline.pipeline.is_valid() && made.from == PassShaders::From::FILE) { // the driver has changed since
		made = _shaders.translate(r_pipeline.code, p_is_worker);
		r_pipeline.make(made.shader);
	}
	UtilityFunctions::print_verbose(vformat("GrassField: compiled '%s', shader %s in %d ms, pipeline in %d ms", r_pipeline.code.name,
			origin_of(made.from), int64_t(has_shader - begin), int64_t(Time::get_singleton()->get_ticks_msec() - has_shader)));
}

// Returns whether only fields with a refused pass would use this one: the CPU has these fields, and a driver would take seconds for it.
bool CompileQueue::is_useless(const PassCode &p_code) {
	std::lock_guard lock(_mutex);
	return std::ranges::any_of(
			_refused, [&](const PassCode &p_refused) { return p_refused.is_everybodys() || p_code.helps == p_refused.key(); });
}

void CompileQueue::Pipeline::make(const RID &p_shader) {
	shader = p_shader;
	pipeline = shader.is_valid() ? main_device()->compute_pipeline_create(shader, constants_of(code)) : RID();
}

void CompileQueue::finish(Pipeline &r_pipeline) {
	if (_queue.remove(&r_pipeline)) {
		compile(r_pipeline, false);
	} else {
		std::unique_lock lock(_mutex);
		_has_compiled.wait(lock, [&] { return r_pipeline.is_done.load(); });
	}
}

bool CompileQueue::is_empty() {
	std::lock_guard lock(_mutex);
	return _pipelines.empty();
}

bool CompileQueue::is_refused(const PassCode &p_code) {
	std::lock_guard lock(_mutex);
	return std::ranges::find(_refused, p_code.key(), &PassCode::key) != _refused.end();
}

std::vector<PassCode> CompileQueue::take_refused() {
	std::lock_guard lock(_mutex);
	const auto first = _refused.begin() + std::ptrdiff_t(std::exchange(_refused_taken, _refused.size()));
	return { first, _refused.end() };
}

void CompileQueue::free_pipelines() {
	_queue.finish();
	std::lock_guard lock(_mutex);
	_refused.clear();
	_refused_count = _refused_taken = 0;
	_compiling = _deciding = 0;
	_shaders.free();
	_pipelines.clear();
}

} // namespace grass
