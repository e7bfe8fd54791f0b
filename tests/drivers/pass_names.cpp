// SPDX-License-Identifier: MIT
#include "pass_names.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

enum : uint32_t {
	HEADER_WORDS = 5,
	OP_DEBUG_FIRST = 2, // sources and names; the engine strips them
	OP_DEBUG_LAST = 8,
	OP_ENTRY_POINT = 15,
	OP_EXECUTION_MODE = 16,
	OP_DECORATE = 71,
	OP_MEMBER_DECORATE = 72,
	MODEL_COMPUTE = 5,
	DECORATION_RELAXED = 0, // these two are of results, of which inlining makes more
	DECORATION_NO_CONTRACTION = 42,
};

struct Marks {
	bool is_compute = false;
	uint64_t declared = 0; // of bindings, layouts and the workgroup's size, in any order
	size_t words = 0; // without what is stripped
};

struct Pass {
	std::string name;
	Marks marks;
};

uint64_t hash_of(std::span<const uint32_t> p_words, uint64_t p_begin) {
	uint64_t hash = 14695981039346656037u + p_begin;
	for (const uint32_t word : p_words) {
		hash = (hash ^ word) * 1099511628211u;
	}
	return hash;
}

Marks marks_of(std::span<const uint32_t> p_code) {
	Marks marks;
	for (size_t i = HEADER_WORDS; i < p_code.size() && p_code[i] >> 16 > 0; i += p_code[i] >> 16) {
		const uint32_t *at = &p_code[i], op = *at & 0xffff, length = *at >> 16;
		marks.words += op >= OP_DEBUG_FIRST && op <= OP_DEBUG_LAST ? 0 : length;
		marks.is_compute = marks.is_compute || (op == OP_ENTRY_POINT && at[1] == MODEL_COMPUTE);
		const bool is_of_result = op == OP_DECORATE && (at[2] == DECORATION_RELAXED || at[2] == DECORATION_NO_CONTRACTION);
		if (op == OP_EXECUTION_MODE || op == OP_MEMBER_DECORATE || (op == OP_DECORATE && !is_of_result)) {
			marks.declared += hash_of(std::span(at + 2, length - 2), op); // not its id, which may change
		}
	}
	return marks;
}

// `shaders_solver_simulate.glsl_GRASS_EDGES.spv` is `simulate_GRASS_EDGES`.
std::string name_of(const std::filesystem::path &p_file) {
	const std::string name = p_file.stem().string();
	const size_t type = name.find(".glsl"), begin = name.rfind('_', type) + 1;
	return name.substr(begin, type - begin) + name.substr(type + 5);
}

std::vector<Pass> read_passes(const char *p_folder) {
	std::vector<Pass> passes;
	for (const auto &entry : std::filesystem::directory_iterator(p_folder)) {
		std::vector<uint32_t> code(entry.file_size() / sizeof(uint32_t));
		std::ifstream file(entry.path(), std::ios::binary);
		if (entry.path().extension() == ".spv" && file.read(reinterpret_cast<char *>(code.data()), std::streamsize(entry.file_size()))) {
			passes.push_back({ name_of(entry.path()), marks_of(code) });
		}
	}
	if (passes.empty()) {
		std::fprintf(stderr, "grass layer: there are no passes in %s\n", p_folder);
		std::abort();
	}
	return passes;
}

} // namespace

const char *pass_of(const char *p_folder, std::span<const uint32_t> p_code) {
	const Marks marks = marks_of(p_code);
	if (p_folder == nullptr || !marks.is_compute) {
		return nullptr;
	}
	static const std::vector<Pass> passes = read_passes(p_folder);
	const Pass *found = nullptr;
	size_t least = SIZE_MAX;
	for (const Pass &pass : passes) { // variants declare the same: of them the one of this length
		const size_t a = pass.marks.words, b = marks.words, off = a > b ? a - b : b - a;
		if (pass.marks.declared == marks.declared && off < least) {
			found = &pass;
			least = off;
		}
	}
	return found != nullptr ? found->name.c_str() : nullptr;
}
