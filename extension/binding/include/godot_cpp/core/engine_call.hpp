// SPDX-License-Identifier: MIT
// The engine's objects seen from C++: their wrappers, their methods, the singletons.
#pragma once

#include <godot_cpp/core/builtin_call.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

using GodotObject = void; // an object on the engine's side

namespace internal {

// The wrapper of an engine object: of its own class, or of the nearest ancestor that the binding knows. Made when
// first asked for, freed with the object. Null for null.
Object *get_object_instance_binding(GodotObject *p_object);

// One method of an engine class, looked up at its first call and then called straight. Engines are built without some: calls of these do
// nothing and return what is empty, and the first one says so.
struct EngineMethod {
	const char *class_name;
	const char *name;
	int64_t hash;
	std::atomic<GDExtensionMethodBindPtr> bind = nullptr;
	std::atomic<bool> is_missed = false;

	GDExtensionMethodBindPtr get() {
		GDExtensionMethodBindPtr found = bind.load(std::memory_order_acquire);
		return likely(found) ? found : find();
	}
	void call(GodotObject *p_owner, const GDExtensionConstTypePtr *p_arguments, void *r_result) {
		if (const GDExtensionMethodBindPtr found = get(); likely(found)) {
			gdextension_interface::object_method_bind_ptrcall(found, p_owner, p_arguments, r_result);
		}
	}
	Variant call_variants(GodotObject *p_owner, const Variant *const *p_arguments, int p_count);
	GDExtensionMethodBindPtr find();
};

// One singleton, looked up until it is found; forgotten when the engine frees it.
struct Singleton {
	const char *name;
	std::atomic<Object *> object = nullptr;

	Object *get() {
		Object *found = object.load(std::memory_order_acquire);
		return likely(found) ? found : find();
	}
	Object *find();
};
void forget_singleton(void *p_wrapper);
void free_singletons();

} // namespace internal

} // namespace godot
