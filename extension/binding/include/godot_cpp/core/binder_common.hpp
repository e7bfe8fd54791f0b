// SPDX-License-Identifier: MIT
// Calls of C++ functions with arguments as the engine passes them: Variants, or pointers to plain values.
#pragma once

#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/core/type_info.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <tuple>

namespace godot::internal {

// The object as a T, or null where it is none (defined in core/object.hpp).
template <typename T> T *object_as(Object *p_object);
template <typename T> GodotObject *owner_of(const T *p_object);
Object *object_in_ref(const void *p_ref);
void set_ref(void *r_ref, GodotObject *p_object);

template <typename T> inline constexpr bool is_ref = false;
template <typename T> inline constexpr bool is_ref<Ref<T>> = true;

// One argument from a Variant.
template <typename T> struct VariantCaster {
	using Bare = std::remove_cvref_t<T>;

	static Bare cast(const Variant &p_value) {
		if constexpr (std::is_pointer_v<Bare>) {
			return object_as<std::remove_cv_t<std::remove_pointer_t<Bare>>>(p_value.get_validated_object());
		} else if constexpr (std::is_enum_v<Bare> || is_bitfield<Bare>) {
			return static_cast<Bare>(p_value.operator int64_t());
		} else if constexpr (std::is_same_v<Bare, Variant>) {
			return p_value;
		} else if constexpr (is_ref<Bare> || !std::is_void_v<typename Element<Bare>::Type>) {
			return Bare(p_value);
		} else {
			return p_value.operator Bare();
		}
	}
};

// One argument from, or result to, the place where a pointer call keeps it.
template <typename T> struct PtrToArg {
	using Bare = std::remove_cvref_t<T>;

	static Bare convert(const void *p_place) {
		if constexpr (std::is_pointer_v<Bare>) {
			using Class = std::remove_cv_t<std::remove_pointer_t<Bare>>;
			return p_place ? static_cast<Class *>(get_object_instance_binding(*static_cast<GodotObject *const *>(p_place))) : nullptr;
		} else if constexpr (is_ref<Bare>) {
			return p_place ? Bare(static_cast<typename NamedClass<Bare>::Type *>(object_in_ref(p_place))) : Bare();
		} else if constexpr (std::is_same_v<Bare, bool>) {
			return *static_cast<const uint8_t *>(p_place) != 0;
		} else if constexpr (std::is_integral_v<Bare> || std::is_enum_v<Bare> || is_bitfield<Bare>) {
			return static_cast<Bare>(*static_cast<const int64_t *>(p_place));
		} else if constexpr (std::is_floating_point_v<Bare>) {
			return static_cast<Bare>(*static_cast<const double *>(p_place));
		} else if constexpr (!std::is_void_v<typename Element<Bare>::Type>) {
			return Bare(*static_cast<const Array *>(p_place));
		} else {
			return *static_cast<const Bare *>(p_place);
		}
	}

	static void encode(const Bare &p_value, void *r_place) {
		if constexpr (std::is_pointer_v<Bare>) {
			*static_cast<GodotObject **>(r_place) = owner_of(p_value);
		} else if constexpr (is_ref<Bare>) {
			set_ref(r_place, owner_of(p_value.ptr()));
		} else if constexpr (std::is_same_v<Bare, bool>) {
			*static_cast<uint8_t *>(r_place) = p_value;
		} else if constexpr (std::is_integral_v<Bare> || std::is_enum_v<Bare> || is_bitfield<Bare>) {
			*static_cast<int64_t *>(r_place) = static_cast<int64_t>(p_value);
		} else if constexpr (std::is_floating_point_v<Bare>) {
			*static_cast<double *>(r_place) = p_value;
		} else if constexpr (!std::is_void_v<typename Element<Bare>::Type>) {
			*static_cast<Array *>(r_place) = p_value;
		} else {
			*static_cast<Bare *>(r_place) = p_value;
		}
	}
};

// Whose function it is, what it takes and what it gives. Class is void for functions of no object.
template <typename F> struct FunctionTraits;
template <typename C, typename R, typename... P> struct FunctionTraits<R (C::*)(P...)> {
	using Class = C;
	using Result = R;
	using Parameters = std::tuple<P...>;
	static constexpr bool CONST = false;
};
template <typename C, typename R, typename... P> struct FunctionTraits<R (C::*)(P...) const> : FunctionTraits<R (C::*)(P...)> {
	static constexpr bool CONST = true;
};
template <typename R, typename... P> struct FunctionTraits<R (*)(P...)> {
	using Class = void;
	using Result = R;
	using Parameters = std::tuple<P...>;
	static constexpr bool CONST = false;
};
template <typename C, typename R, typename... P> struct FunctionTraits<R (C::*)(P...) noexcept> : FunctionTraits<R (C::*)(P...)> {};
template <typename C, typename R, typename... P>
struct FunctionTraits<R (C::*)(P...) const noexcept> : FunctionTraits<R (C::*)(P...) const> {};

template <typename F> inline constexpr size_t parameter_count = std::tuple_size_v<typename FunctionTraits<F>::Parameters>;
template <typename F, size_t I> using Parameter = std::tuple_element_t<I, typename FunctionTraits<F>::Parameters>;

// Marks the error where the value's type cannot become the parameter's.
void check_argument(const Variant &p_value, GDExtensionVariantType p_type, int p_index, GDExtensionCallError &r_error);
void mark_argument(GDExtensionVariantType p_type, int p_index, GDExtensionCallError &r_error);

template <typename T> auto checked_argument(const Variant &p_value, int p_index, GDExtensionCallError &r_error) {
	check_argument(p_value, type_code<T>, p_index, r_error);
	auto value = VariantCaster<T>::cast(p_value);
	if constexpr (type_code<T> == GDEXTENSION_VARIANT_TYPE_OBJECT) {
		bool empty = false;
		if constexpr (is_ref<std::remove_cvref_t<T>>) {
			empty = value.is_null();
		} else {
			empty = value == nullptr;
		}
		if (empty && p_value.get_validated_object()) { // an object of another class
			mark_argument(type_code<T>, p_index, r_error);
		}
	}
	return value;
}

template <typename F, typename... A> decltype(auto) invoke(void *p_instance, F p_function, A &&...p_arguments) {
	using Class = typename FunctionTraits<F>::Class;
	if constexpr (std::is_void_v<Class>) {
		return p_function(std::forward<A>(p_arguments)...);
	} else {
		return (static_cast<Class *>(p_instance)->*p_function)(std::forward<A>(p_arguments)...);
	}
}

template <typename T> Variant to_variant(const T &p_value) {
	if constexpr (std::is_enum_v<T> || is_bitfield<T>) {
		return static_cast<int64_t>(p_value);
	} else {
		return p_value;
	}
}

// p_arguments holds exactly as many Variants as the function has parameters.
template <typename F, size_t... I>
void call_with_variants(void *p_instance, F p_function, const Variant *const *p_arguments, Variant &r_result, GDExtensionCallError &r_error,
		std::index_sequence<I...>) {
	if constexpr (std::is_void_v<typename FunctionTraits<F>::Result>) {
		invoke(p_instance, p_function, checked_argument<Parameter<F, I>>(*p_arguments[I], I, r_error)...);
	} else {
		r_result = to_variant(invoke(p_instance, p_function, checked_argument<Parameter<F, I>>(*p_arguments[I], I, r_error)...));
	}
}

template <typename F, size_t... I>
void call_with_pointers(
		void *p_instance, F p_function, const GDExtensionConstTypePtr *p_arguments, void *r_result, std::index_sequence<I...>) {
	if constexpr (std::is_void_v<typename FunctionTraits<F>::Result>) {
		invoke(p_instance, p_function, PtrToArg<Parameter<F, I>>::convert(p_arguments[I])...);
	} else {
		PtrToArg<typename FunctionTraits<F>::Result>::encode(
				invoke(p_instance, p_function, PtrToArg<Parameter<F, I>>::convert(p_arguments[I])...), r_result);
	}
}

template <typename T, typename F>
void call_with_ptr_args(T *p_instance, F p_function, const GDExtensionConstTypePtr *p_arguments, void *r_result) {
	using Class = typename FunctionTraits<F>::Class;
	Class *instance = p_instance;
	call_with_pointers(instance, p_function, p_arguments, r_result, std::make_index_sequence<parameter_count<F>>{});
}

} // namespace godot::internal
