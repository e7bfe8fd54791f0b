// SPDX-License-Identifier: MIT
#include "gpu/pass_shaders.h"

#include "gpu/device.h"

#include <godot_cpp/classes/rd_shader_spirv.hpp>

using namespace godot;

namespace grass {

PassShaders::Made PassShaders::make(const PassCode &p_code, bool p_is_worker) {
	{
		std::lock_guard lock(_mutex);
		const auto known = _shaders.find(p_code.spirv.data());
		if (known != _shaders.end()) {
			return { known->second, From::PROCESS };
		}
	}
	const PackedByteArray kept = p_is_worker ? _cache.read(p_code.spirv) : PackedByteArray();
	if (!kept.is_empty()) {
		const RID shader = main_device()->shader_create_from_bytecode(kept);
		if (shader.is_valid()) {
			return { keep(p_code, shader), From::FILE };
		}
	}
	return translate(p_code, p_is_worker);
}

PassShaders::Made PassShaders::translate(const PassCode &p_code, bool p_is_worker) {
	Ref<RDShaderSPIRV> spirv;
	spirv.instantiate();
	spirv->set_stage_bytecode(RenderingDevice::SHADER_STAGE_COMPUTE, to_bytes(p_code.spirv));
	const PackedByteArray made = main_device()->shader_compile_binary_from_spirv(spirv, p_code.name);
	const RID shader = made.is_empty() ? RID() : main_device()->shader_create_from_bytecode(made);
	if (shader.is_valid() && p_is_worker) {
		_cache.write(p_code.spirv, made);
	}
	return { keep(p_code, shader), From::CODE };
}

RID PassShaders::keep(const PassCode &p_code, const RID &p_shader) {
	if (p_shader.is_valid()) {
		std::lock_guard lock(_mutex);
		_shaders[p_code.spirv.data()] = p_shader;
		_made.push_back(p_shader);
	}
	return p_shader;
}

void PassShaders::free() {
	for (const RID &shader : _made) { // also frees its pipelines
		main_device()->free_rid(shader);
	}
	_made.clear();
	_shaders.clear();
}

} // namespace grass
