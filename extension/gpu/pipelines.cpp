// SPDX-License-Identifier: MIT
#include "gpu/pipelines.h"

#include "convert.h"
#include "gpu/device.h"

#include <godot_cpp/classes/rd_pipeline_specialization_constant.hpp>
#include <godot_cpp/classes/rd_shader_spirv.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace grass {

Pipelines &Pipelines::get() {
	static Pipelines pipelines;
	return pipelines;
}

// Whoever calls it has made its state COMPILING.
void Pipelines::compile(Pipeline &r_pipeline) {
	Ref<RDShaderSPIRV> spirv;
	spirv.instantiate();
	spirv->set_stage_bytecode(RenderingDevice::SHADER_STAGE_COMPUTE, to_bytes(r_pipeline.code.spirv));
	RenderingDevice *device = main_device();
	Ref<RDPipelineSpecializationConstant> constant;
	constant.instantiate();
	constant->set_constant_id(0);
	constant->set_value(r_pipeline.code.constant);
	TypedArray<Ref<RDPipelineSpecializationConstant>> constants;
	constants.push_back(constant);
	r_pipeline.shader = device->shader_create_from_spirv(spirv, r_pipeline.code.name);
	if (r_pipeline.shader.is_valid()) {
		r_pipeline.pipeline = device->compute_pipeline_create(r_pipeline.shader, constants);
	}
	if (!r_pipeline.pipeline.is_valid()) {
		ERR_PRINT(vformat(
				"GrassField: the graphics driver refused the compute pass '%s'. Set the node's `backend` to CPU.", r_pipeline.code.name));
	}
	std::lock_guard lock(_mutex);
	r_pipeline.state = Pipeline::State::DONE;
	_compiling--;
	_is_done.notify_all();
}

void Pipelines::compile_waiting() {
	std::unique_lock lock(_mutex);
	while (!_waiting.empty()) {
		Pipeline &pipeline = *_waiting.front();
		_waiting.pop_front();
		pipeline.state = Pipeline::State::COMPILING;
		lock.unlock();
		compile(pipeline);
		lock.lock();
	}
	_is_working = false;
}

bool Pipelines::is_compiled(Pipeline &r_pipeline, bool p_wait) {
	std::unique_lock lock(_mutex);
	if (p_wait && r_pipeline.state == Pipeline::State::WAITING) {
		std::erase(_waiting, &r_pipeline);
		r_pipeline.state = Pipeline::State::COMPILING;
		lock.unlock();
		compile(r_pipeline);
		return true;
	}
	_is_done.wait(lock, [&] { return !p_wait || r_pipeline.state == Pipeline::State::DONE; });
	return r_pipeline.state == Pipeline::State::DONE;
}

Pipelines::Pipeline &Pipelines::find(const Code &p_code) {
	Pipeline &known = _known[{ p_code.spirv.data(), p_code.constant }];
	if (known.code.name != nullptr) {
		return known;
	}
	known.code = p_code;
	_compiling++;
	std::unique_lock lock(_mutex);
	_waiting.push_back(&known);
	if (!_is_working) {
		_is_working = true;
		lock.unlock();
		WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
		if (_task >= 0) {
			pool->wait_for_task_completion(_task); // it has done its work
		}
		_task = pool->add_native_task(
				[](void *p_self) { static_cast<Pipelines *>(p_self)->compile_waiting(); }, this, true, "GrassField's compute passes");
	}
	return known;
}

void Pipelines::free() {
	{
		std::lock_guard lock(_mutex);
		_compiling -= int(_waiting.size());
		_waiting.clear();
	}
	if (_task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(_task);
		_task = -1;
	}
	for (auto &[code, known] : _known) {
		if (known.shader.is_valid()) { // takes the pipeline with it
			main_device()->free_rid(known.shader);
		}
	}
	_known.clear();
}

} // namespace grass
