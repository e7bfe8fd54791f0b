// SPDX-License-Identifier: MIT
// Buffers, textures and pipelines on the renderer's own RenderingDevice. Everything here may only be called on
// the render thread (RenderingServer.call_on_render_thread).
#pragma once

#include <godot_cpp/classes/rd_uniform.hpp>
#include <godot_cpp/classes/rendering_device.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace grass {

// The device that the engine draws with; null in Compatibility and headless.
godot::RenderingDevice *main_device();

// A record as the bytes that a push constant takes.
template <typename T> godot::PackedByteArray record_bytes(const T &p_record) {
	godot::PackedByteArray bytes;
	bytes.resize(sizeof(T));
	std::memcpy(bytes.ptrw(), &p_record, sizeof(T));
	return bytes;
}

// A storage buffer that grows with what is uploaded, and skips an upload of what it already holds.
class GpuBuffer {
public:
	~GpuBuffer() { free(); }

	// Allocates p_bytes, all zero: the device writes them, nothing travels. Frees what was there.
	void allocate(int64_t p_bytes);
	// Allocates them if it has another size.
	void resize(int64_t p_bytes);
	void clear(); // to zeros
	// Uploads plain records; the buffer grows by doubling (then rid() changes). Returns the bytes that travelled.
	template <typename T> int64_t upload(std::span<const T> p_records) {
		return upload_bytes(reinterpret_cast<const uint8_t *>(p_records.data()), int64_t(p_records.size_bytes()));
	}
	// Writes records at p_offset bytes into what was allocated. Returns the bytes that travelled.
	template <typename T> int64_t write(int64_t p_offset, std::span<const T> p_records) {
		return write_bytes(p_offset, reinterpret_cast<const uint8_t *>(p_records.data()), int64_t(p_records.size_bytes()));
	}
	int64_t write(int64_t p_offset, const godot::PackedByteArray &p_bytes);
	void free();

	godot::RID rid() const { return _rid; }
	int64_t size() const { return _size; }

private:
	int64_t upload_bytes(const uint8_t *p_data, int64_t p_bytes);
	int64_t write_bytes(int64_t p_offset, const uint8_t *p_data, int64_t p_bytes);

	godot::RID _rid;
	int64_t _size = 0; // bytes
	godot::PackedByteArray _uploaded; // what the buffer holds since the last upload
};

// A compute pass: one shader, its pipeline, and one uniform set that is made again when a resource in it changed.
class GpuPass {
public:
	static constexpr uint32_t MAX_ROW = 65535; // workgroups along one dimension that every device takes

	~GpuPass() { free(); }

	enum class Compile { NOW, LATER };

	// What a pipeline is made of.
	struct Code {
		std::span<const uint32_t> spirv;
		const char *name;
		int constant = 0; // value of its specialization constant 0, if it has one
	};

	// Takes the pipeline of p_code, made when it is first asked for and kept: drivers take seconds for it. LATER: a worker thread makes
	// it, after those that were asked for before, and until is_ready() the pass does nothing.
	void create(const Code &p_code, Compile p_when = Compile::NOW);
	// Lets a worker thread make that pipeline, if nobody did. Whether it is there.
	static bool prepare(const Code &p_code);
	// Of one that prepare() said to be there: whether the driver has refused it.
	static bool is_refused(const Code &p_code) { return !find(p_code).pipeline.is_valid(); }
	// Frees all pipelines, for when the library is unloaded.
	static void free_pipelines();
	// What the pass binds at p_binding of set 0; a change is noticed by dispatch().
	void bind_buffer(int p_binding, const godot::RID &p_buffer);
	void bind_image(int p_binding, const godot::RID &p_texture);
	void bind_sampled(int p_binding, const godot::RID &p_sampler, const godot::RID &p_texture);
	// Adds the pass to an open compute list. p_constants: the push constant's bytes, a multiple of 16. More than
	// MAX_ROW workgroups are laid out in rows, with some too many in the last.
	void dispatch(int64_t p_list, const godot::PackedByteArray &p_constants, uint32_t p_groups);
	void free();
	bool is_ready();
	// Passes that are being made, or wait for that. From any thread.
	static int compiling() { return _compiling; }
	// Whether it binds something else than in its last dispatch.
	bool has_changed() const { return _changed; }

private:
	struct Binding {
		int type;
		godot::RID first, second;
		bool operator==(const Binding &) const = default;
	};
	void bind(int p_binding, const Binding &p_to);
	bool refresh_set();

	enum class State { WAITING, COMPILING, DONE };
	struct Pipeline {
		Code code{ {}, nullptr }; // without a name: not begun yet
		godot::RID shader, pipeline; // whose compiles them until they are done; invalid if the driver refuses them
		State state = State::WAITING; // guarded by _mutex
	};
	static Pipeline &find(const Code &p_code);
	static void compile(Pipeline &r_pipeline);
	static void compile_waiting(void *);
	// Whether the pipeline is there, or has been refused; waits for it if asked to, or compiles it itself.
	static bool is_compiled(Pipeline &r_pipeline, bool p_wait);

	static std::map<std::pair<const uint32_t *, int>, Pipeline> _pipelines; // by their code and constant; render thread only
	static std::atomic<int> _compiling;
	// One task of the WorkerThreadPool compiles one after the other: several would hold up the engine's own tasks, and one that is
	// still queued when the game ends is never run.
	static int64_t _task; // -1: none; render thread only
	static std::mutex _mutex;
	static std::condition_variable _is_done; // a pipeline
	static std::deque<Pipeline *> _waiting; // guarded by _mutex
	static bool _is_working; // the task; guarded by _mutex

	Pipeline *_source = nullptr; // of _pipelines
	godot::RID _pipeline, _set;
	std::vector<Binding> _bindings;
	bool _changed = true;
};

} // namespace grass
