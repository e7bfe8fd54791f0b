// SPDX-License-Identifier: MIT
#include "vertex_numbers.h"

#include <array>
#include <cstring>
#include <initializer_list>

namespace {

// Numbers of the SPIR-V specification.
enum : uint32_t {
	HEADER_WORDS = 5,
	OP_EXTENSION = 10,
	OP_ENTRY_POINT = 15,
	OP_CAPABILITY = 17,
	OP_VARIABLE = 59,
	OP_LOAD = 61,
	OP_DECORATE = 71,
	OP_INT_ADD = 128,
	OP_INT_SUBTRACT = 130,
	MODEL_VERTEX = 0,
	STORAGE_INPUT = 1,
	DECORATION_BUILT_IN = 11,
	BUILT_IN_VERTEX_INDEX = 42,
	BUILT_IN_INSTANCE_INDEX = 43,
	BUILT_IN_BASE_VERTEX = 4424,
	BUILT_IN_BASE_INSTANCE = 4425,
	CAPABILITY_DRAW_PARAMETERS = 4427,
	VERSION_1_3 = 0x10300, // from there on the capability needs no extension
};

using Words = std::vector<uint32_t>;

void put(Words &r_to, uint32_t p_op, std::initializer_list<uint32_t> p_operands) {
	r_to.push_back(uint32_t(p_operands.size() + 1) << 16 | p_op);
	r_to.insert(r_to.end(), p_operands);
}

// A number that a shader reads, and the one that is taken from it.
struct Number {
	uint32_t base_built_in;
	uint32_t index = 0, base = 0; // ids of the variables; index 0: the shader does not read it
};

struct Shader {
	bool is_vertex = false, has_capability = false;
	std::array<Number, 2> numbers{ Number{ BUILT_IN_BASE_VERTEX }, Number{ BUILT_IN_BASE_INSTANCE } };
	uint32_t bound = 0;
};

uint32_t op_of(const uint32_t *p_at) {
	return *p_at & 0xffff;
}

uint32_t length_of(const uint32_t *p_at) {
	return *p_at >> 16;
}

Shader read_shader(std::span<const uint32_t> p_code) {
	Shader shader;
	shader.bound = p_code[3];
	for (size_t i = HEADER_WORDS; i < p_code.size() && length_of(&p_code[i]) > 0; i += length_of(&p_code[i])) {
		const uint32_t *at = &p_code[i];
		if (op_of(at) == OP_ENTRY_POINT) {
			shader.is_vertex = at[1] == MODEL_VERTEX;
		} else if (op_of(at) == OP_CAPABILITY && at[1] == CAPABILITY_DRAW_PARAMETERS) {
			shader.has_capability = true;
		} else if (op_of(at) == OP_DECORATE && at[2] == DECORATION_BUILT_IN) {
			if (at[3] == BUILT_IN_VERTEX_INDEX || at[3] == BUILT_IN_INSTANCE_INDEX) {
				shader.numbers[at[3] - BUILT_IN_VERTEX_INDEX].index = at[1];
			}
		}
	}
	for (Number &number : shader.numbers) {
		number.base = shader.bound++;
	}
	return shader;
}

const Number *number_of(const Shader &p_shader, uint32_t p_variable) {
	for (const Number &number : p_shader.numbers) {
		if (number.index == p_variable && p_variable != 0) {
			return &number;
		}
	}
	return nullptr;
}

void put_capability(Words &r_to, uint32_t p_version) {
	put(r_to, OP_CAPABILITY, { CAPABILITY_DRAW_PARAMETERS });
	if (p_version < VERSION_1_3) {
		uint32_t name[8] = {};
		std::memcpy(name, "SPV_KHR_shader_draw_parameters", 31);
		put(r_to, OP_EXTENSION, { name[0], name[1], name[2], name[3], name[4], name[5], name[6], name[7] });
	}
}

// p_at: the load of a number.
void put_load(Words &r_to, const uint32_t *p_at, const Number &p_number, Counting p_counting, Shader &r_shader) {
	const uint32_t type = p_at[1], result = p_at[2], index = r_shader.bound++, base = r_shader.bound++;
	put(r_to, OP_LOAD, { type, index, p_number.index });
	put(r_to, OP_LOAD, { type, base, p_number.base });
	if (p_counting == Counting::FROM_ZERO) {
		put(r_to, OP_INT_SUBTRACT, { type, result, index, base });
	} else {
		const uint32_t difference = r_shader.bound++;
		put(r_to, OP_INT_SUBTRACT, { type, difference, index, base });
		put(r_to, OP_INT_ADD, { type, result, difference, base });
	}
}

// Any other instruction, and what goes with it.
void put_copy(Words &r_to, const uint32_t *p_at, const Shader &p_shader) {
	const size_t begin = r_to.size();
	r_to.insert(r_to.end(), p_at, p_at + length_of(p_at));
	if (op_of(p_at) == OP_ENTRY_POINT) { // its interface lists what it reads
		for (const Number &number : p_shader.numbers) {
			if (number.index != 0) {
				r_to.push_back(number.base);
			}
		}
		r_to[begin] = uint32_t(r_to.size() - begin) << 16 | OP_ENTRY_POINT;
	} else if (op_of(p_at) == OP_VARIABLE) {
		if (const Number *number = number_of(p_shader, p_at[2])) {
			put(r_to, OP_VARIABLE, { p_at[1], number->base, STORAGE_INPUT });
		}
	}
}

} // namespace

std::vector<uint32_t> count_vertices(std::span<const uint32_t> p_code, Counting p_counting) {
	Shader shader = read_shader(p_code);
	if (!shader.is_vertex || p_counting == Counting::FROM_BASE || (shader.numbers[0].index == 0 && shader.numbers[1].index == 0)) {
		return {};
	}
	Words to(p_code.begin(), p_code.begin() + HEADER_WORDS);
	bool is_decorated = false;
	for (size_t i = HEADER_WORDS; i < p_code.size(); i += length_of(&p_code[i])) {
		const uint32_t *at = &p_code[i];
		if (op_of(at) != OP_CAPABILITY && !shader.has_capability) {
			put_capability(to, p_code[1]);
			shader.has_capability = true;
		}
		if (op_of(at) == OP_DECORATE && !is_decorated) {
			for (const Number &number : shader.numbers) {
				if (number.index != 0) {
					put(to, OP_DECORATE, { number.base, DECORATION_BUILT_IN, number.base_built_in });
				}
			}
			is_decorated = true;
		}
		const Number *loaded = op_of(at) == OP_LOAD ? number_of(shader, at[3]) : nullptr;
		if (loaded != nullptr) {
			put_load(to, at, *loaded, p_counting, shader);
		} else {
			put_copy(to, at, shader);
		}
	}
	to[3] = shader.bound;
	return to;
}
