// SPDX-License-Identifier: MIT
// Buffers, textures and pipelines on the renderer's own RenderingDevice. Everything here must be called on the render thread
// (RenderingServer.call_on_render_thread).
#pragma once

#include "core/solver/step.h"
#include "gpu/compile_queue.h"
#include "shared/convert.h"

#include <godot_cpp/classes/rd_uniform.hpp>
#include <godot_cpp/classes/rendering_device.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace grass {

// Returns the device that the engine draws with; null in Compatibility and headless.
godot::RenderingDevice *main_device();

// A storage buffer that grows with the uploaded data, and skips an upload of data that it already holds.
class GpuBuffer {
public:
	~GpuBuffer() { free(); }

	// Allocates p_bytes, whatever is in them, for a buffer that has none; on any thread.
	void create(int64_t p_bytes);
	// Allocates p_bytes, all zero, for the device to write, without an upload. Frees the old buffer.
	void allocate(int64_t p_bytes);
	// Allocates p_bytes if the buffer has another size.
	void resize(int64_t p_bytes);
	// Swaps with r_other. Keeps the first p_kept parts of p_part bytes, and moves others from one place to another.
	void swap_parts(GpuBuffer &r_other, int64_t p_part, int64_t p_kept, std::span<const SlotMove> p_moves);
	void clear(); // to zeros
	// Uploads plain records; the buffer grows by doubling (then rid() changes). Returns the uploaded bytes.
	template <typename T> int64_t upload(std::span<const T> p_records) { return upload_bytes(std::as_bytes(p_records)); }
	// Writes records into the allocated buffer at p_offset bytes. Returns the uploaded bytes.
	template <typename T> int64_t write(int64_t p_offset, std::span<const T> p_records) { return write(p_offset, to_bytes(p_records)); }
	int64_t write(int64_t p_offset, const godot::PackedByteArray &p_bytes);
	void free();

	godot::RID rid() const { return _rid; }
	int64_t size() const { return _size; }

private:
	int64_t upload_bytes(std::span<const std::byte> p_bytes);

	godot::RID _rid;
	int64_t _size = 0; // bytes
	godot::PackedByteArray _uploaded; // contents as of the last upload
};

// A compute pass: one shader, its pipeline, and one uniform set that is made again when a resource in it has changed.
class GpuPass {
public:
	~GpuPass() { free(); }

	enum class Compile { NOW, LATER };

	// Uses the pipeline of p_code from the CompileQueue. LATER: the pass does nothing until is_ready().
	void create(const PassCode &p_code, Compile p_when = Compile::NOW);
	// Queues p_code, once. Returns whether its pipeline is done.
	static bool prepare(const PassCode &p_code, Need p_need = Need::PREPARED);
	// Sets what the pass binds at p_binding of set 0. dispatch() notices a change.
	void bind_buffer(int p_binding, const godot::RID &p_buffer);
	void bind_image(int p_binding, const godot::RID &p_texture);
	void bind_sampled(int p_binding, const godot::RID &p_sampler, const godot::RID &p_texture);
	// Adds the pass to an open compute list. p_constants: the push constant block, exactly as large as the pass declares it: Godot 4.7
	// refuses any other size. If there are more workgroups than a dimension can hold, they are laid out in rows, see
	// shaders/base/rows.inc.
	template <typename T> void dispatch(int64_t p_list, const T &p_constants, uint32_t p_groups) {
		dispatch_bytes(p_list, to_bytes(std::span<const T>(&p_constants, 1)), p_groups);
	}
	void free();
	bool is_created() const { return _source != nullptr; }
	bool is_ready();
	// Waits until the pass is ready, or the driver has refused it.
	void finish() { CompileQueue::get().finish(*_source); }
	// Returns true if its bindings changed since its last dispatch.
	bool has_changed() const { return _changed; }

private:
	struct Binding {
		int type;
		godot::RID first, second;
		bool operator==(const Binding &) const = default;
	};
	void bind(int p_binding, const Binding &p_to);
	void dispatch_bytes(int64_t p_list, const godot::PackedByteArray &p_constants, uint32_t p_groups);
	bool refresh_set();

	CompileQueue::Pipeline *_source = nullptr;
	godot::RID _pipeline, _set;
	std::vector<Binding> _bindings;
	bool _changed = true;
};

} // namespace grass
