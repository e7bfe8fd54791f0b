// SPDX-License-Identifier: MIT
#include "draw/shared_shader.h"

#include "draw/frame_share.h"
#include "draw/task_queue.h"

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

using namespace godot;

namespace grass {

namespace {

std::mutex making; // held by the worker that is making a shader

PackedByteArray zeros(int64_t p_bytes) {
	PackedByteArray bytes;
	bytes.resize(p_bytes);
	bytes.fill(0);
	return bytes;
}

// Returns a degenerate triangle. Only its format counts, which must be that of the later meshes.
Dictionary make_surface(VertexKind p_vertices) {
	constexpr int64_t VERSION = int64_t(RenderingServer::ARRAY_FLAG_FORMAT_CURRENT_VERSION), INDEX = Mesh::ARRAY_FORMAT_INDEX;
	constexpr int64_t GROUND = Mesh::ARRAY_FORMAT_VERTEX | Mesh::ARRAY_FORMAT_NORMAL | Mesh::ARRAY_FORMAT_TANGENT;
	constexpr int64_t PLANT = GROUND | Mesh::ARRAY_FORMAT_TEX_UV | Mesh::ARRAY_FORMAT_CUSTOM0 |
			(int64_t(Mesh::ARRAY_CUSTOM_RGB_FLOAT) << Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT);
	const bool has_vertices = p_vertices != VertexKind::BLADE;
	Dictionary surface;
	surface["primitive"] = RenderingServer::PRIMITIVE_TRIANGLES;
	surface["format"] = VERSION | INDEX |
			(p_vertices == VertexKind::PLANT                   ? PLANT
							: p_vertices == VertexKind::GROUND ? GROUND
															   : int64_t(Mesh::ARRAY_FLAG_USES_EMPTY_VERTEX_ARRAY));
	surface["vertex_count"] = has_vertices ? 3 : 0;
	surface["vertex_data"] = zeros(has_vertices ? 3 * (12 + 4 + 4) : 0); // position, normal, tangent
	if (p_vertices == VertexKind::PLANT) {
		surface["attribute_data"] = zeros(3 * (8 + 12)); // UV, three numbers
	}
	surface["index_count"] = 3;
	surface["index_data"] = zeros(3 * (has_vertices ? 2 : 4));
	surface["aabb"] = AABB(Vector3(), Vector3(1, 1, 1));
	return surface;
}

// Makes a shader and the pipelines that the renderer draws with. On the main thread this would hold up a frame, by some 80 ms or, with an
// empty driver cache, by more than a second.
struct ShaderJob {
	explicit ShaderJob(const ShaderText &p_text) :
			code(make_shader_code(p_text.code, p_text.look)), surface(make_surface(p_text.vertices)) {}
	ShaderJob(const ShaderJob &) = delete;
	ShaderJob &operator=(const ShaderJob &) = delete;
	~ShaderJob() {
		if (mesh.is_valid()) {
			RenderingServer::get_singleton()->free_rid(mesh);
		}
	}

	// Runs on a worker thread. If a thread other than the renderer's creates a mesh, the call returns when all pipelines of its materials
	// are ready. The engine's loaders wait for those of a scene in this way.
	void work() {
		{
			std::lock_guard lock(making);
			shader.instantiate();
			shader->set_code(code);
			material.instantiate();
			material->set_shader(shader);
			surface["material"] = material->get_rid(); // compiles the shader
		}
		TypedArray<Dictionary> surfaces;
		surfaces.push_back(surface);
		mesh = RenderingServer::get_singleton()->mesh_create_from_surfaces(surfaces);
		is_done = true;
	}

	String code;
	Dictionary surface; // the mesh data for the renderer
	Ref<Shader> shader; // valid once it is done
	Ref<ShaderMaterial> material;
	RID mesh;
	std::atomic<bool> is_done = false;
};

using ShaderKey = std::tuple<const char *, int, std::string>; // address of the code, features, hook
std::map<ShaderKey, Ref<Shader>> shaders;
std::map<ShaderKey, std::shared_ptr<ShaderJob>> jobs; // that are not in `shaders` yet
TaskQueue queue("GrassField's shaders", TaskQueue::Priority::LOW);

void release_shader_jobs();

Callable release_jobs() {
	return callable_mp_static(&release_shader_jobs);
}

void release_shader_jobs() {
	RenderingServer *server = RenderingServer::get_singleton();
	if (server->is_connected("frame_post_draw", release_jobs())) {
		server->disconnect("frame_post_draw", release_jobs());
	}
	queue.release();
}

bool is_mobile() {
	const RenderingServer *server = RenderingServer::get_singleton();
	return server->get_current_rendering_method() == String("mobile") && server->get_rendering_device() != nullptr;
}

// Lets the engine compile a shader. Returns once drawing with it cannot hang, though it may delay a frame. Tasks begin in the order in
// which they were added: when the last one runs, all parts of the shader have begun or are done. If the shader were needed earlier, Mobile
// would wait for the parts while holding a lock that tasks for pipelines need too; if these occupy all threads, no part ever begins
// (Godot's issue 123060).
void compile(Shader &p_shader) {
	p_shader.get_rid(); // the engine parses it and adds a task for each thread
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	pool->wait_for_task_completion(pool->add_native_task([](void *) {}, nullptr, true, "GrassField's mark behind a shader"));
}

ShaderKey key_of(const ShaderText &p_text) {
	return { p_text.code, p_text.look.features, p_text.look.hook.utf8().get_data() };
}
} // namespace

bool has_shader_workers() {
	if (RenderingServer::get_singleton()->get_rendering_device() == nullptr) {
		return false;
	}
	const OS *os = OS::get_singleton();
	// Each frame of a film must show all of its grass, however long that takes. A job needs a second thread. In Mobile the main thread
	// hangs if tasks for a job's pipelines occupy all threads (Godot's issue 123060).
	static const bool has_workers = !os->has_feature("movie") && os->get_processor_count() > 1 &&
			int64_t(ProjectSettings::get_singleton()->get_setting("threading/worker_pool/max_threads", -1)) != 1 && !is_mobile();
	return has_workers;
}

String make_shader_code(const char *p_code, const Look &p_look) {
	const auto &[features, hook] = p_look;
	String head = "shader_type spatial;";
	head += features & SHADER_MAP ? "\n#define GRASS_MAP" : "";
	head += features & SHADER_SPECIES ? "\n#define GRASS_SPECIES" : "";
	head += features & SHADER_CARDS ? "\n#define GRASS_CARDS" : "";
	head += features & SHADER_PLANTS ? "\n#define GRASS_PLANTS" : "";
	head += features & SHADER_TERRAIN ? "\n#define GRASS_TERRAIN" : "";
	head += features & SHADER_LEDGES ? "\n#define GRASS_LEDGES" : "";
	head += features & SHADER_IMPOSTOR ? "\n#define GRASS_IMPOSTOR" : "";
	head += hook.is_empty() ? "" : "\n#define GRASS_HOOK";
	const String code = String::utf8(p_code).replace("shader_type spatial;", head);
	return hook.is_empty() ? code : code.replace("GRASS_HOOK_TEXT", hook);
}

Ref<Shader> shared_shader(const ShaderText &p_text) {
	const ShaderKey key = key_of(p_text);
	const auto known = shaders.find(key);
	if (known != shaders.end()) {
		return known->second;
	}
	Ref<Shader> &shader = shaders[key];
	shader.instantiate();
	shader->set_code(make_shader_code(p_text.code, p_text.look));
	if (is_mobile()) {
		compile(**shader);
	}
	return shader;
}

bool prepare_shader(const ShaderText &p_text) {
	const ShaderKey key = key_of(p_text);
	if (shaders.contains(key)) {
		return true;
	}
	if (has_shader_workers()) {
		std::shared_ptr<ShaderJob> &job = jobs[key];
		if (!job) {
			job = std::make_shared<ShaderJob>(p_text);
			queue.push(job.get(), [job] { job->work(); });
		}
		const bool is_done = job->is_done;
		if (is_done) {
			shaders[key] = job->shader;
			jobs.erase(key);
		}
		return is_done;
	}
	static const char user = 0;
	if (FrameShare::Turn turn(&user); turn.has_time()) {
		shared_shader(p_text)->get_rid(); // makes the engine compile it, if it has not yet
	}
	return false;
}

void drop_hooked_shaders() {
	std::erase_if(
			shaders, [](const auto &p_entry) { return !std::get<2>(p_entry.first).empty() && p_entry.second->get_reference_count() == 1; });
}

void hold_shader_jobs() {
	if (!has_shader_workers()) {
		return;
	}
	queue.hold();
	{
		std::lock_guard lock(making); // waits for a thread that is making a shader, at most some 90 ms; pipelines may still be in progress
	}
	RenderingServer *server = RenderingServer::get_singleton();
	if (!server->is_connected("frame_post_draw", release_jobs())) {
		server->connect("frame_post_draw", release_jobs());
	}
}

void expect_motion_vectors() {
	static bool are_known = false;
	if (!std::exchange(are_known, true)) {
		hold_shader_jobs();
	}
}

void forget_shader_jobs() {
	std::erase_if(jobs, [](const auto &p_entry) { return queue.remove(p_entry.second.get()); });
	release_shader_jobs();
}

void free_shared_shaders() {
	queue.finish();
	jobs.clear();
	shaders.clear();
}

} // namespace grass
