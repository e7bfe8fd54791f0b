// SPDX-License-Identifier: MIT
// Objects, and methods of the engine's classes, which do nothing here but count references.
#include "host.h"

#include <cstdlib>
#include <cstring>
#include <map>

namespace host {

namespace {

struct Method {
	std::string class_name, name;
};

constexpr size_t PADDING = 16; // of memory that the engine would keep a count in front of

void *allocate(size_t p_bytes, GDExtensionBool p_padded) {
	char *memory = static_cast<char *>(std::malloc(p_bytes + PADDING));
	return p_padded ? memory + PADDING : memory;
}

void *reallocate(void *p_memory, size_t p_bytes, GDExtensionBool p_padded) {
	const size_t before = p_padded && p_memory ? PADDING : 0;
	char *memory = static_cast<char *>(std::realloc(p_memory ? static_cast<char *>(p_memory) - before : nullptr, p_bytes + PADDING));
	return p_padded ? memory + PADDING : memory;
}

void release(void *p_memory, GDExtensionBool p_padded) {
	std::free(p_padded && p_memory ? static_cast<char *>(p_memory) - PADDING : p_memory);
}

void *binding_of(GDExtensionObjectPtr p_object, void *p_token, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
	Object &object = *static_cast<Object *>(p_object);
	if (!object.binding && p_callbacks) {
		object.binding = p_callbacks->create_callback(p_token, p_object);
		object.callbacks = *p_callbacks;
	}
	return object.binding;
}

void free_binding(GDExtensionObjectPtr p_object, void *p_token) {
	Object &object = *static_cast<Object *>(p_object);
	if (object.binding && object.callbacks.free_callback) {
		object.callbacks.free_callback(p_token, p_object, object.binding);
	}
	object.binding = nullptr;
}

GDExtensionObjectPtr singleton(GDExtensionConstStringNamePtr p_name) {
	static std::map<std::string, Object> singletons;
	Object &object = singletons[name_text(p_name)];
	object.class_name = make_name(name_text(p_name));
	return &object;
}

// What a method returns is a zero in as many bytes as its caller has cleared already.
void call(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object, const GDExtensionConstTypePtr *, GDExtensionTypePtr r_result) {
	const Method &method = *static_cast<const Method *>(p_method);
	if (const Transform3D *place = p_object ? static_cast<const Object *>(p_object)->place : nullptr) {
		if (method.name == "is_inside_tree") {
			*static_cast<GDExtensionBool *>(r_result) = true;
		} else if (method.name == "get_global_transform") {
			*static_cast<Transform3D *>(r_result) = *place;
		}
	}
	if (method.class_name != "RefCounted" || !p_object) {
		return;
	}
	Object &object = *static_cast<Object *>(p_object);
	const int before = object.references;
	object.references += method.name == "reference" ? 1 : (method.name == "unreference" ? -1 : 0);
	if (method.name == "get_reference_count") {
		*static_cast<int64_t *>(r_result) = object.references;
	} else if (r_result) { // whether it lives; for unreference() whether it is to go
		*static_cast<uint8_t *>(r_result) = method.name == "unreference" ? object.references == 0 : before > 0;
	}
}

GDExtensionMethodBindPtr find_method(GDExtensionConstStringNamePtr p_class, GDExtensionConstStringNamePtr p_method, GDExtensionInt) {
	return new Method{ name_text(p_class), name_text(p_method) };
}

} // namespace

Object *construct(Name p_class) {
	Object *object = nullptr;
	if (!construct_registered(p_class, object)) {
		object = new Object;
		object->class_name = p_class;
	}
	return object;
}

void offer_objects(Functions &r_functions) {
	offer(r_functions, "mem_alloc2", &allocate);
	offer(r_functions, "mem_realloc2", &reallocate);
	offer(r_functions, "mem_free2", &release);
	offer(r_functions, "classdb_get_method_bind", &find_method);
	offer(r_functions, "object_method_bind_ptrcall", &call);
	offer(
			r_functions, "object_method_bind_call",
			+[](GDExtensionMethodBindPtr, GDExtensionObjectPtr, const GDExtensionConstVariantPtr *, GDExtensionInt,
					 GDExtensionUninitializedVariantPtr r_result, GDExtensionCallError *r_error) {
				*static_cast<Variant *>(r_result) = {};
				r_error->error = GDEXTENSION_CALL_OK;
			});
	offer(r_functions, "global_get_singleton", &singleton);
	offer(
			r_functions, "classdb_construct_object2",
			+[](GDExtensionConstStringNamePtr p_class) -> GDExtensionObjectPtr { return construct(*static_cast<const Name *>(p_class)); });
	offer(
			r_functions, "classdb_get_class_tag", +[](GDExtensionConstStringNamePtr p_class) {
				return const_cast<void *>(static_cast<const void *>(*static_cast<const Name *>(p_class)));
			});
	offer(
			r_functions, "object_set_instance",
			+[](GDExtensionObjectPtr p_object, GDExtensionConstStringNamePtr p_class, GDExtensionClassInstancePtr p_instance) {
				static_cast<Object *>(p_object)->class_name = *static_cast<const Name *>(p_class);
				static_cast<Object *>(p_object)->instance = p_instance;
			});
	offer(
			r_functions, "object_set_instance_binding",
			+[](GDExtensionObjectPtr p_object, void *, void *p_binding, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
				static_cast<Object *>(p_object)->binding = p_binding;
				static_cast<Object *>(p_object)->callbacks = p_callbacks ? *p_callbacks : GDExtensionInstanceBindingCallbacks{};
			});
	offer(r_functions, "object_get_instance_binding", &binding_of);
	offer(r_functions, "object_free_instance_binding", &free_binding);
	offer(
			r_functions, "object_get_class_name",
			+[](GDExtensionConstObjectPtr p_object, GDExtensionClassLibraryPtr, GDExtensionUninitializedStringNamePtr r_name) {
				*static_cast<Name *>(r_name) = static_cast<const Object *>(p_object)->class_name;
				return GDExtensionBool(true);
			});
	offer(
			r_functions, "object_get_instance_id", +[](GDExtensionConstObjectPtr p_object) { return GDObjectInstanceID(p_object); });
	offer(
			r_functions, "object_get_instance_from_id", +[](GDObjectInstanceID p_id) { return GDExtensionObjectPtr(p_id); });
	offer(
			r_functions, "object_destroy", +[](GDExtensionObjectPtr) {}); // nothing is freed, so nothing is used after it was
	offer(
			r_functions, "ref_get_object",
			+[](GDExtensionConstRefPtr p_ref) { return p_ref ? *static_cast<const GDExtensionObjectPtr *>(p_ref) : nullptr; });
	offer(
			r_functions, "ref_set_object",
			+[](GDExtensionRefPtr r_ref, GDExtensionObjectPtr p_object) { *static_cast<GDExtensionObjectPtr *>(r_ref) = p_object; });
	offer(
			r_functions, "callable_custom_create2", +[](GDExtensionUninitializedTypePtr r_callable, GDExtensionCallableCustomInfo2 *) {
				std::memset(r_callable, 0, TYPE_SIZES[GDEXTENSION_VARIANT_TYPE_CALLABLE]);
			});
}

} // namespace host
