// SPDX-License-Identifier: MIT
#include "gpu/compile_queue.h"

#include "core/base/layout.h"
#include "gpu/device.h"

#include <godot_cpp/classes/rd_pipeline_specialization_constant.hpp>
#include <godot_cpp/classes/rd_shader_spirv.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace grass {

namespace {

RID compile_shader(const PassCode &p_code) {
	Ref<RDShaderSPIRV> spirv;
	spirv.instantiate();
	spirv->set_stage_bytecode(RenderingDevice::SHADER_STAGE_COMPUTE, to_bytes(p_code.spirv));
	return main_device()->shader_create_from_spirv(spirv, p_code.name);
}

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
		add(GRASS_CONSTANT_CROWD, p_code.crowd);
	}
	return constants;
}

} // namespace

CompileQueue &CompileQueue::get() {
	static CompileQueue queue;
	return queue;
}

CompileQueue::Pipeline &CompileQueue::find(const PassCode &p_code) {
	Pipeline &known = _pipelines[{ p_code.spirv.data(), p_code.method, p_code.crowd }];
	std::unique_lock lock(_mutex);
	if (known.state != Pipeline::State::NEW) {
		return known;
	}
	known.code = p_code;
	known.state = Pipeline::State::WAITING;
	_compiling++;
	_waiting.push_back(&known);
	if (!_is_working) {
		_is_working = true;
		lock.unlock();
		start_worker();
	}
	return known;
}

void CompileQueue::start_worker() {
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	if (_task >= 0) {
		pool->wait_for_task_completion(_task); // it has done its work
	}
	_task = pool->add_native_task(&CompileQueue::compile_waiting, this, true, "GrassField's compute passes");
}

void CompileQueue::compile_waiting(void *p_queue) {
	CompileQueue &queue = *static_cast<CompileQueue *>(p_queue);
	std::unique_lock lock(queue._mutex);
	while (!queue._waiting.empty()) {
		Pipeline &pipeline = *queue._waiting.front();
		queue._waiting.pop_front();
		pipeline.state = Pipeline::State::COMPILING;
		lock.unlock();
		queue.compile(pipeline);
		lock.lock();
	}
	queue._is_working = false;
}

// The caller has set its state to COMPILING.
void CompileQueue::compile(Pipeline &r_pipeline) {
	r_pipeline.shader = compile_shader(r_pipeline.code);
	if (r_pipeline.shader.is_valid()) {
		r_pipeline.pipeline = main_device()->compute_pipeline_create(r_pipeline.shader, constants_of(r_pipeline.code));
	}
	if (!r_pipeline.pipeline.is_valid()) {
		ERR_PRINT(vformat(
				"GrassField: the graphics driver refused the compute pass '%s'. Set the node's `backend` to CPU.", r_pipeline.code.name));
	}
	std::lock_guard lock(_mutex);
	r_pipeline.state = Pipeline::State::DONE;
	_compiling--;
	_has_compiled.notify_all();
}

bool CompileQueue::is_done(const Pipeline &p_pipeline) {
	std::lock_guard lock(_mutex);
	return p_pipeline.state == Pipeline::State::DONE;
}

void CompileQueue::finish(Pipeline &r_pipeline) {
	std::unique_lock lock(_mutex);
	if (r_pipeline.state == Pipeline::State::WAITING) {
		std::erase(_waiting, &r_pipeline);
		r_pipeline.state = Pipeline::State::COMPILING;
		lock.unlock();
		compile(r_pipeline);
		return;
	}
	_has_compiled.wait(lock, [&] { return r_pipeline.state == Pipeline::State::DONE; });
}

void CompileQueue::free_pipelines() {
	{
		std::lock_guard lock(_mutex);
		_compiling -= int(_waiting.size());
		_waiting.clear();
	}
	if (_task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(_task);
		_task = -1;
	}
	for (auto &[code, known] : _pipelines) {
		if (known.shader.is_valid()) { // frees the pipeline, too
			main_device()->free_rid(known.shader);
		}
	}
	_pipelines.clear();
}

} // namespace grass
