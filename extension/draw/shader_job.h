// SPDX-License-Identifier: MIT
// Makes a shader and the pipelines that the renderer draws with. On the main thread this would hold up a frame, by some 80 ms or, with an
// empty driver cache, by more than a second.
#pragma once

#include "draw/shared_shader.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <atomic>

namespace grass {

class ShaderJob {
public:
	explicit ShaderJob(const ShaderText &p_text);
	ShaderJob(const ShaderJob &) = delete;
	ShaderJob &operator=(const ShaderJob &) = delete;
	~ShaderJob();

	// Does the work: on a worker thread if there is a RenderingDevice.
	void work();
	// Returns when no thread is making a shader, after at most some 90 ms. Their pipelines may still be in progress.
	static void wait_for_shaders();
	bool is_done() const { return _is_done; }
	const godot::Ref<godot::Shader> &get_shader() const { return _shader; } // valid once it is done

private:
	godot::String _code;
	godot::Dictionary _surface; // the mesh data for the renderer
	godot::Ref<godot::Shader> _shader;
	godot::Ref<godot::ShaderMaterial> _material;
	godot::RID _mesh;
	std::atomic<bool> _is_done = false;
};

} // namespace grass
