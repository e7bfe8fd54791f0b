// SPDX-License-Identifier: MIT
// The shaders of compute passes: one for each code, since the engine translates code and not constants. On Direct3D 12 that takes seconds
// at every start, so the result is cached (gpu/shader_cache.h).
#pragma once

#include "gpu/shader_cache.h"

#include <godot_cpp/variant/rid.hpp>

#include <map>
#include <mutex>
#include <vector>

namespace grass {

struct PassCode;

class PassShaders {
public:
	enum class From { PROCESS, FILE, CODE }; // already made for other constants; cached by an earlier run; translated
	struct Made {
		godot::RID shader; // invalid: refused
		From from;
	};

	// Makes a shader. p_is_worker: the caller is the worker thread, which may use files.
	Made make(const PassCode &p_code, bool p_is_worker);
	// Does the same without the files.
	Made translate(const PassCode &p_code, bool p_is_worker);
	// Frees the shaders and their pipelines. Nothing may be compiled any more.
	void free();

private:
	godot::RID keep(const PassCode &p_code, const godot::RID &p_shader);

	std::mutex _mutex;
	std::map<const uint32_t *, godot::RID> _shaders; // by code; guarded by _mutex
	std::vector<godot::RID> _made; // guarded by _mutex
	ShaderCache _cache;
};

} // namespace grass
