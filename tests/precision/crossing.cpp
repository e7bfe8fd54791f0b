// SPDX-License-Identifier: MIT
// A library of its own on the binding, which takes vectors from the host and gives some back (tests/host/far.cpp). It has the binding and
// the extension's conversions, and nothing else, so it is built in a fraction of the extension's time.
#include "shared/convert.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

class Crossing : public RefCounted {
	GDCLASS(Crossing, RefCounted)

public:
	// As the extension finds where a camera is in a field, which the GPU gets as floats.
	Vector3 seen_from(const Transform3D &p_field, const Vector3 &p_eye) const {
		const Eigen::Vector3f eye = (grass::to_eigen(p_field).inverse(Eigen::Isometry) * grass::to_eigen(p_eye)).cast<float>();
		return grass::to_godot(Eigen::Vector3d(eye.cast<double>()));
	}

	Transform3D inverse_of(const Transform3D &p_transform) const { return p_transform.affine_inverse(); }

	PackedVector3Array moved(const PackedVector3Array &p_places, const Vector3 &p_by) const {
		PackedVector3Array places;
		places.resize(p_places.size());
		for (int64_t i = 0; i < p_places.size(); i++) {
			places[i] = p_places[i] + p_by;
		}
		return places;
	}

protected:
	static void _bind_methods() {
		ClassDB::bind_method(D_METHOD("seen_from", "field", "eye"), &Crossing::seen_from);
		ClassDB::bind_method(D_METHOD("inverse_of", "transform"), &Crossing::inverse_of);
		ClassDB::bind_method(D_METHOD("moved", "places", "by"), &Crossing::moved);
	}
};

extern "C" GDExtensionBool GDE_EXPORT crossing_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer([](ModuleInitializationLevel p_level) {
		if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
			GDREGISTER_CLASS(Crossing);
		}
	});
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
