// SPDX-License-Identifier: MIT
// The shaders of compute passes: one for each code, since the engine translates code and not constants. On Direct3D 12 it takes seconds for
// that, at every start, so what it made is kept (gpu/shader_cache.h).
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
	enum class From { PROCESS, FILE, CODE }; // made for other constants before; kept by an earlier run; translated
	struct Made {
		godot::RID shader; // invalid: refused
		From from;
	};

	// p_is_worker: the caller is the worker thread, which may use files.
	Made make(const PassCode &p_code, bool p_is_worker);
	// Translates what came from a file and could not be used. From the worker thread.
	Made make_again(const PassCode &p_code);
	// Frees them, and with them the pipelines; nothing is compiled any more.
	void free();

private:
	godot::RID keep(const PassCode &p_code, const godot::RID &p_shader);
	Made translate(const PassCode &p_code, bool p_is_worker);

	std::mutex _mutex;
	std::map<const uint32_t *, godot::RID> _shaders; // by code; guarded by _mutex
	std::vector<godot::RID> _made; // guarded by _mutex
	ShaderCache _cache;
};

} // namespace grass
