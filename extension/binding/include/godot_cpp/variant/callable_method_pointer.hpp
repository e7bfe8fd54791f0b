// SPDX-License-Identifier: MIT
// Callables that run a C++ method, callable_mp(object, &Class::method), or a function, callable_mp_static(&function). Two of the same
// object and method are equal.
#pragma once

#include <godot_cpp/core/object.hpp>

namespace godot {

namespace internal {

class CallableMethod {
public:
	virtual ~CallableMethod() = default;
	virtual void call(const Variant *const *p_arguments, int64_t p_count, Variant &r_result, GDExtensionCallError &r_error) const = 0;

	uint64_t object_id = 0; // 0: of no object
	int argument_count = 0;
	const void *identity = nullptr; // object, method: the bytes to compare
	size_t identity_size = 0;
};

// Takes ownership.
Callable make_callable(CallableMethod *p_method);
// Whether the count fits; marks the error otherwise.
bool check_argument_count(int64_t p_count, int64_t p_expected, GDExtensionCallError &r_error);

template <typename T, typename F> class CallableMethodOf : public CallableMethod {
public:
	CallableMethodOf(T *p_object, F p_function) {
		memset(static_cast<void *>(&_target), 0, sizeof(_target));
		_target.object = p_object;
		_target.function = p_function;
		identity = &_target;
		identity_size = sizeof(_target);
		argument_count = parameter_count<F>;
		if constexpr (!std::is_void_v<T>) {
			object_id = p_object->get_instance_id();
		}
	}

	void call(const Variant *const *p_arguments, int64_t p_count, Variant &r_result, GDExtensionCallError &r_error) const override {
		if (check_argument_count(p_count, parameter_count<F>, r_error)) {
			typename FunctionTraits<F>::Class *object = _target.object;
			call_with_variants(object, _target.function, p_arguments, r_result, r_error, std::make_index_sequence<parameter_count<F>>{});
		}
	}

private:
	struct {
		T *object;
		F function;
	} _target;
};

// The method must be of the object's very class, as upstream demands.
template <typename T, typename R, typename... P> Callable callable_of(T *p_object, R (T::*p_method)(P...)) {
	return make_callable(memnew((CallableMethodOf<T, R (T::*)(P...)>)(p_object, p_method)));
}
template <typename T, typename R, typename... P> Callable callable_of(const T *p_object, R (T::*p_method)(P...) const) {
	return make_callable(memnew((CallableMethodOf<T, R (T::*)(P...) const>)(const_cast<T *>(p_object), p_method)));
}
template <typename R, typename... P> Callable callable_of_static(R (*p_function)(P...)) {
	return make_callable(memnew((CallableMethodOf<void, R (*)(P...)>)(nullptr, p_function)));
}

} // namespace internal

} // namespace godot

#define callable_mp(m_object, m_method) ::godot::internal::callable_of(m_object, m_method)
#define callable_mp_static(m_function) ::godot::internal::callable_of_static(m_function)
