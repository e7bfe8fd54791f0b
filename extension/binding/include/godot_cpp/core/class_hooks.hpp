// SPDX-License-Identifier: MIT
// What the engine calls on an object of the extension, made from the members that its class declares.
#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/classes/wrapped.hpp>

namespace godot::internal {

// A list handed to the engine as C structures; freed by its count and place.
const GDExtensionPropertyInfo *make_property_list(const List<PropertyInfo> &p_list, uint32_t *r_count);
void free_property_list(GDExtensionClassInstancePtr p_instance, const GDExtensionPropertyInfo *p_list, uint32_t p_count);

template <typename T> struct ClassHooks {
	using Parent = typename T::parent_type;

	static T *self(GDExtensionClassInstancePtr p_instance) { return reinterpret_cast<T *>(p_instance); }

	// A member counts only where the class declares it itself: an inherited one is called for the ancestor.
	static constexpr bool HAS_NOTIFICATION = std::is_same_v<decltype(&T::_notification), void (T::*)(int)>;
	static constexpr bool HAS_SET = std::is_same_v<decltype(&T::_set), bool (T::*)(const StringName &, const Variant &)>;
	static constexpr bool HAS_GET = std::is_same_v<decltype(&T::_get), bool (T::*)(const StringName &, Variant &) const>;
	static constexpr bool HAS_LIST = std::is_same_v<decltype(&T::_get_property_list), void (T::*)(List<PropertyInfo> *) const>;
	static constexpr bool HAS_VALIDATE = std::is_same_v<decltype(&T::_validate_property), void (T::*)(PropertyInfo &) const>;

	static void notification(GDExtensionClassInstancePtr p_instance, int32_t p_what, GDExtensionBool p_reversed) {
		if constexpr (Parent::_is_extension) {
			if (!p_reversed) {
				ClassHooks<Parent>::notification(p_instance, p_what, p_reversed);
			}
		}
		if constexpr (HAS_NOTIFICATION) {
			self(p_instance)->_notification(p_what);
		}
		if constexpr (Parent::_is_extension) {
			if (p_reversed) {
				ClassHooks<Parent>::notification(p_instance, p_what, p_reversed);
			}
		}
	}

	static GDExtensionBool set(
			GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name, GDExtensionConstVariantPtr p_value) {
		if constexpr (Parent::_is_extension) {
			if (ClassHooks<Parent>::set(p_instance, p_name, p_value)) {
				return true;
			}
		}
		if constexpr (HAS_SET) {
			return self(p_instance)->_set(*static_cast<const StringName *>(p_name), *static_cast<const Variant *>(p_value));
		}
		return false;
	}

	static GDExtensionBool get(
			GDExtensionClassInstancePtr p_instance, GDExtensionConstStringNamePtr p_name, GDExtensionVariantPtr r_value) {
		if constexpr (Parent::_is_extension) {
			if (ClassHooks<Parent>::get(p_instance, p_name, r_value)) {
				return true;
			}
		}
		if constexpr (HAS_GET) {
			return self(p_instance)->_get(*static_cast<const StringName *>(p_name), *static_cast<Variant *>(r_value));
		}
		return false;
	}

	static const GDExtensionPropertyInfo *get_property_list(GDExtensionClassInstancePtr p_instance, uint32_t *r_count) {
		List<PropertyInfo> list;
		self(p_instance)->_get_property_list(&list);
		return make_property_list(list, r_count);
	}

	static GDExtensionBool validate_property(GDExtensionClassInstancePtr p_instance, GDExtensionPropertyInfo *p_property) {
		bool changed = false;
		if constexpr (Parent::_is_extension) {
			changed = ClassHooks<Parent>::validate_property(p_instance, p_property);
		}
		if constexpr (HAS_VALIDATE) {
			PropertyInfo info(p_property);
			self(p_instance)->_validate_property(info);
			info._update(p_property);
			changed = true;
		}
		return changed;
	}

	static GDExtensionObjectPtr create(void *, GDExtensionBool p_notify) {
		if constexpr (std::is_abstract_v<T>) {
			return nullptr;
		} else {
			before_construction<T>();
			T *object = new (DefaultAllocator{}) T;
			if (p_notify) {
				after_construction(object);
			}
			return object->_owner;
		}
	}

	static GDExtensionClassInstancePtr recreate(void *, GDExtensionObjectPtr p_object) {
		if constexpr (std::is_abstract_v<T>) {
			return nullptr;
		} else {
			before_construction<T>();
			next_construction().recreated = p_object;
			return new (DefaultAllocator{}) T;
		}
	}

	static void free(void *, GDExtensionClassInstancePtr p_instance) {
		T *object = self(p_instance);
		object->~T();
		Memory::free_static(object);
	}

	// Classes that the engine knows only by their base bind nothing of their own.
	static void bind() {
		void (*const own)() = &T::_bind_methods;
		void (*const inherited)() = &Parent::_bind_methods;
		if (own != inherited) { // as the program runs: with -fsanitize=undefined an address is no constant
			own();
		}
		T::template register_virtuals<T, Parent>();
	}
};

// Extension objects are their own wrapper: nothing to make, nothing to free.
inline constexpr GDExtensionInstanceBindingCallbacks extension_callbacks = {
	[](void *, void *) -> void * { return nullptr; },
	[](void *, void *, void *) {},
	[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },
};

// Wrappers of engine objects.
template <typename T>
inline constexpr GDExtensionInstanceBindingCallbacks engine_callbacks = {
	[](void *, void *p_object) -> void * {
		next_construction() = { nullptr, nullptr, p_object };
		return new (DefaultAllocator{}) T;
	},
	[](void *, void *, void *p_wrapper) {
		if constexpr (T::_is_singleton) {
			forget_singleton(p_wrapper);
		}
		static_cast<T *>(p_wrapper)->~T();
		Memory::free_static(p_wrapper);
	},
	[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },
};

template <typename T> constexpr ClassIdentity make_identity() {
	if constexpr (T::_is_extension) {
		return { &T::_engine_type::get_class_static, &T::get_class_static, &extension_callbacks };
	} else {
		return { &T::get_class_static, nullptr, &engine_callbacks<T> };
	}
}
template <typename T> inline constexpr ClassIdentity class_identity = make_identity<T>();

template <typename T> void prepare_object() {
	next_construction() = { &class_identity<T>, nullptr, nullptr };
}

} // namespace godot::internal
