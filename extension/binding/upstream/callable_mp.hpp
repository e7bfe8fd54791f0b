// SPDX-License-Identifier: MIT
// Only for builds with a real godot-cpp, which SConstruct makes include this file first. Its callable_mp reads the number of the object
// from the object each time the engine looks whether the callable is valid. The engine does so while it emits a signal, so a script that
// frees a listener there ends the process. These callables keep the number.
#pragma once

#include <godot_cpp/variant/callable_method_pointer.hpp>

namespace grass {

template <typename Method> class KeptMethod : public Method {
public:
	template <typename T, typename F> KeptMethod(T *p_object, F p_method) : Method(p_object, p_method), _id(p_object->get_instance_id()) {}

	godot::ObjectID get_object() const override { return godot::ObjectID(_id); }

private:
	uint64_t _id;
};

template <typename Method, typename T, typename F> godot::Callable keep_method(T *p_object, F p_method) {
	return godot::internal::create_callable_from_ccmp(memnew(KeptMethod<Method>(p_object, p_method)));
}

template <typename T, typename... P> godot::Callable kept_callable(T *p_object, void (T::*p_method)(P...)) {
	return keep_method<godot::CallableCustomMethodPointer<T, P...>>(p_object, p_method);
}
template <typename T, typename R, typename... P> godot::Callable kept_callable(T *p_object, R (T::*p_method)(P...)) {
	return keep_method<godot::CallableCustomMethodPointerRet<T, R, P...>>(p_object, p_method);
}
template <typename T, typename R, typename... P> godot::Callable kept_callable(const T *p_object, R (T::*p_method)(P...) const) {
	return keep_method<godot::CallableCustomMethodPointerRetC<T, R, P...>>(p_object, p_method);
}

} // namespace grass

#undef callable_mp
#define callable_mp(m_object, m_method) ::grass::kept_callable(m_object, m_method)
