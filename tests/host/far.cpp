// SPDX-License-Identifier: MIT
// Calls with places 10,000 km from the origin, where two floats are one metre apart.
#include "host.h"

#include <cstdio>
#include <cstring>
#include <type_traits>
#include <utility>

namespace host {

namespace {

const real_t FAR = real_t(1e7); // metres
constexpr size_t MOST_BYTES = 16 * sizeof(real_t); // of a result

int wrong = 0;

void expect(bool p_is_right, const std::string &p_what) {
	if (!p_is_right) {
		std::fprintf(stderr, "far from the origin: %s\n", p_what.c_str());
		wrong++;
	}
}

template <class T> Variant variant(int p_type, const T &p_value) {
	Variant made;
	set_value(made, p_type, &p_value);
	return made;
}

struct List {
	Vectors vectors = nullptr;
	void *unused = nullptr;
};

Variant variant(const Vector3 &p_value) {
	return variant(GDEXTENSION_VARIANT_TYPE_VECTOR3, p_value);
}

// Calls a method with Variants, as untyped scripts do, and with pointers, as typed ones do. Both must answer the same.
template <class Result> Result call(Object &p_object, const std::string &p_method, const std::vector<Variant> &p_arguments) {
	const std::string name = *p_object.class_name + "." + p_method;
	const GDExtensionClassMethodInfo *method = find_registered(*p_object.class_name, p_method);
	if (!method) {
		lack("the library's " + name);
	}
	std::vector<GDExtensionConstVariantPtr> variants;
	std::vector<GDExtensionConstTypePtr> pointers;
	for (const Variant &argument : p_arguments) {
		variants.push_back(&argument);
		pointers.push_back(value_of(argument));
	}
	Variant answer = {};
	GDExtensionCallError error = {};
	method->call_func(method->method_userdata, p_object.instance, variants.data(), GDExtensionInt(variants.size()), &answer, &error);
	expect(error.error == GDEXTENSION_CALL_OK, name + " ends with call error " + std::to_string(error.error));
	alignas(8) uint8_t bytes[MOST_BYTES] = {};
	method->ptrcall_func(method->method_userdata, p_object.instance, pointers.data(), bytes);
	Result result, other;
	std::memcpy(&result, bytes, sizeof(result));
	std::memcpy(&other, value_of(answer), sizeof(other));
	expect(TYPE_SIZES[answer.type] == sizeof(Result), name + " answers another type");
	if constexpr (!std::is_same_v<Result, List>) { // which is made anew
		expect(std::memcmp(&result, &other, sizeof(result)) == 0, name + " answers otherwise with pointers");
	}
	return result;
}

Object &make(const char *p_class) {
	Object *object = nullptr;
	if (!construct_registered(make_name(p_class), object)) {
		lack(std::string("the library's class ") + p_class);
	}
	object->class_name = make_name(p_class);
	return *object;
}

bool is(const Vector3 &p_a, double p_x, double p_y, double p_z) {
	return p_a.x == real_t(p_x) && p_a.y == real_t(p_y) && p_a.z == real_t(p_z);
}

// The binding alone, with tests/precision/crossing.cpp.
void check_crossing() {
	Object &crossing = make("Crossing");
	const Transform3D field{ { { 0, 0, 1 }, { 0, 1, 0 }, { -1, 0, 0 } }, { FAR, 0, -FAR } }; // turned by a quarter
	const Variant frame = variant(GDEXTENSION_VARIANT_TYPE_TRANSFORM3D, field);
	const Vector3 eye{ real_t(FAR + 0.25), real_t(1.5), real_t(-FAR - 0.125) };
	expect(is(call<Vector3>(crossing, "seen_from", { frame, variant(eye) }), 0.125, 1.5, 0.25), "an eye lies elsewhere in the field");
	const Transform3D inverse = call<Transform3D>(crossing, "inverse_of", { frame });
	expect(is(inverse.rows[0], 0, 0, -1) && is(inverse.rows[2], 1, 0, 0) && is(inverse.origin, -FAR, 0, -FAR),
			"a transform comes back with other numbers");
	std::vector<Vector3> places{ { FAR, 1, 2 }, eye };
	const Variant list = variant(GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY, List{ &places });
	const Vectors moved = call<List>(crossing, "moved", { list, variant(eye) }).vectors;
	expect(moved && moved->size() == 2, "a list of places has another length");
	expect(moved && is((*moved)[0], 2 * FAR + 0.25, 2.5, -FAR + 1.875) && is((*moved)[1], 2 * FAR + 0.5, 3, -2 * FAR - 0.25),
			"a list of places has other numbers");
}

// The extension itself: a world that stands far away finds the plot of a place as it does at the origin.
void check_world() {
	struct Plot {
		int32_t x, z;
		bool operator==(const Plot &) const = default;
	};
	Object &world = make("GrassWorld");
	const auto plot_at = [&](real_t p_origin, double p_x, double p_z) {
		const Transform3D place{ .origin = { p_origin, 0, -p_origin } };
		world.place = &place;
		const Plot plot = call<Plot>(world, "get_plot_at", { variant(Vector3{ real_t(p_origin + p_x), 0, real_t(-p_origin + p_z) }) });
		world.place = nullptr;
		return plot;
	};
	expect(!(plot_at(0, -0.25, 0.25) == plot_at(0, 0.25, 0.25)), "no plot ends at the world's middle");
	for (const auto &[x, z] : { std::pair(-0.25, 0.25), std::pair(0.25, 0.25), std::pair(0.25, -0.25), std::pair(-0.25, -0.25) }) {
		expect(plot_at(FAR, x, z) == plot_at(0, x, z), "a world takes a place for one of the plot beside it");
	}
}

} // namespace

int check_far() {
	if (find_registered("Crossing", "seen_from")) {
		check_crossing();
	} else {
		check_world();
	}
	return wrong;
}

} // namespace host
