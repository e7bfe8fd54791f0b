// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include "core/base/hash.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

using namespace godot;

namespace grass {

#define GRASS_FUNCTION inline
#include "base/rows.inc"
#undef GRASS_FUNCTION

RenderingDevice *main_device() {
	return RenderingServer::get_singleton()->get_rendering_device();
}

void GpuBuffer::create(int64_t p_bytes) {
	_size = std::max<int64_t>(p_bytes, 16);
	_rid = main_device()->storage_buffer_create(uint32_t(_size));
}

void GpuBuffer::allocate(int64_t p_bytes) {
	free();
	create(p_bytes);
	clear();
}

void GpuBuffer::resize(int64_t p_bytes) {
	if (!_rid.is_valid() || _size != std::max<int64_t>(p_bytes, 16)) {
		allocate(p_bytes);
	}
}

void GpuBuffer::swap_parts(GpuBuffer &r_other, int64_t p_part, int64_t p_kept, std::span<const SlotMove> p_moves) {
	std::swap(_rid, r_other._rid);
	std::swap(_size, r_other._size);
	_uploaded = r_other._uploaded = PackedByteArray();
	const auto copy = [&](int64_t p_from, int64_t p_to, int64_t p_count) {
		if (p_count > 0 && p_part > 0) {
			main_device()->buffer_copy(r_other._rid, _rid, uint32_t(p_from * p_part), uint32_t(p_to * p_part), uint32_t(p_count * p_part));
		}
	};
	copy(0, 0, p_kept);
	for (const SlotMove &move : p_moves) {
		copy(move.from, move.to, move.to == GRASS_NO_SLOT ? 0 : 1);
	}
}

void GpuBuffer::clear() {
	main_device()->buffer_clear(_rid, 0, uint32_t(_size));
	_uploaded = PackedByteArray();
}

int64_t GpuBuffer::upload_bytes(std::span<const std::byte> p_bytes) {
	const int64_t bytes = int64_t(p_bytes.size());
	if (_rid.is_valid() && bytes == 0) {
		return 0;
	}
	if (!_rid.is_valid() || bytes > _size) {
		allocate(int64_t(std::bit_ceil(uint64_t(std::max<int64_t>(bytes, 256)))));
	}
	if (bytes == 0 || (bytes == _uploaded.size() && std::memcmp(_uploaded.ptr(), p_bytes.data(), p_bytes.size()) == 0)) {
		return 0;
	}
	copy_bytes(p_bytes, _uploaded);
	main_device()->buffer_update(_rid, 0, uint32_t(bytes), _uploaded);
	return bytes;
}

int64_t GpuBuffer::write(int64_t p_offset, const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V(p_offset < 0 || p_offset + p_bytes.size() > _size, 0);
	if (!p_bytes.is_empty()) {
		main_device()->buffer_update(_rid, uint32_t(p_offset), uint32_t(p_bytes.size()), p_bytes);
	}
	return p_bytes.size();
}

void GpuBuffer::free() {
	if (_rid.is_valid()) {
		main_device()->free_rid(_rid);
	}
	_rid = RID();
	_size = 0;
	_uploaded = PackedByteArray();
}

void GpuPass::create(const PassCode &p_code, Compile p_when) {
	free();
	_source = &CompileQueue::get().find(p_code, Need::WANTED);
	if (p_when == Compile::NOW) {
		CompileQueue::get().finish(*_source);
	}
}

bool GpuPass::prepare(const PassCode &p_code, Need p_need) {
	return CompileQueue::get().find(p_code, p_need).is_done;
}

bool GpuPass::is_ready() {
	if (!_pipeline.is_valid() && _source != nullptr && _source->is_done) {
		_pipeline = _source->pipeline;
	}
	return _pipeline.is_valid();
}

void GpuPass::bind(int p_binding, const Binding &p_to) {
	if (p_binding >= int(_bindings.size())) {
		_bindings.resize(size_t(p_binding) + 1, Binding{ -1, RID(), RID() });
	}
	if (_bindings[size_t(p_binding)] != p_to) {
		_bindings[size_t(p_binding)] = p_to;
		_changed = true;
	}
}

void GpuPass::bind_buffer(int p_binding, const RID &p_buffer) {
	bind(p_binding, { RenderingDevice::UNIFORM_TYPE_STORAGE_BUFFER, p_buffer, RID() });
}

void GpuPass::bind_image(int p_binding, const RID &p_texture) {
	bind(p_binding, { RenderingDevice::UNIFORM_TYPE_IMAGE, p_texture, RID() });
}

void GpuPass::bind_sampled(int p_binding, const RID &p_sampler, const RID &p_texture) {
	bind(p_binding, { RenderingDevice::UNIFORM_TYPE_SAMPLER_WITH_TEXTURE, p_sampler, p_texture });
}

bool GpuPass::refresh_set() {
	RenderingDevice *device = main_device();
	if (!_changed && device->uniform_set_is_valid(_set)) {
		return true;
	}
	if (_set.is_valid() && device->uniform_set_is_valid(_set)) {
		device->free_rid(_set);
	}
	TypedArray<Ref<RDUniform>> uniforms;
	for (size_t i = 0; i < _bindings.size(); i++) {
		if (_bindings[i].type < 0) {
			continue;
		}
		Ref<RDUniform> uniform;
		uniform.instantiate();
		uniform->set_uniform_type(RenderingDevice::UniformType(_bindings[i].type));
		uniform->set_binding(int(i));
		uniform->add_id(_bindings[i].first);
		if (_bindings[i].second.is_valid()) {
			uniform->add_id(_bindings[i].second);
		}
		uniforms.push_back(uniform);
	}
	_set = device->uniform_set_create(uniforms, _source->shader, 0);
	_changed = false;
	return _set.is_valid();
}

void GpuPass::dispatch_bytes(int64_t p_list, const PackedByteArray &p_constants, uint32_t p_groups) {
	if (!is_ready() || p_groups == 0 || !refresh_set()) {
		return;
	}
	const PassCode &code = _source->code;
	ERR_FAIL_COND_MSG(p_constants.size() != int64_t(code.spirv.pushed),
			vformat("%s declares %d bytes of push constants and is given %d.", code.name, int64_t(code.spirv.pushed), p_constants.size()));
	RenderingDevice *device = main_device();
	device->compute_list_bind_compute_pipeline(p_list, _pipeline);
	device->compute_list_bind_uniform_set(p_list, _set, 0);
	device->compute_list_set_push_constant(p_list, p_constants, uint32_t(p_constants.size()));
	device->compute_list_dispatch(p_list, grass_row_width(p_groups), grass_rows(p_groups), 1);
}

void GpuPass::free() {
	RenderingDevice *device = main_device();
	if (device == nullptr) {
		return;
	}
	if (_set.is_valid() && device->uniform_set_is_valid(_set)) {
		device->free_rid(_set);
	}
	_set = _pipeline = RID();
	_source = nullptr;
	_bindings.clear();
	_changed = true;
}

} // namespace grass
