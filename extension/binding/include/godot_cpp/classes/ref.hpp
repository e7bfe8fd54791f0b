// SPDX-License-Identifier: MIT
// A counted reference to an object that is freed with its last one.
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>

namespace godot {

template <typename T> class Ref {
public:
	Ref() = default;
	Ref(const Ref &p_other) { share(p_other._object); }
	Ref(Ref &&p_other) noexcept { std::swap(_object, p_other._object); }
	template <typename Other> Ref(const Ref<Other> &p_other) { share(Object::cast_to<T>(p_other.ptr())); }
	// Takes part in the life of an object just made, too.
	Ref(T *p_object) { begin(p_object); }
	Ref(const Variant &p_value) { share(Object::cast_to<T>(p_value.get_validated_object())); }
	~Ref() { unref(); }

	void operator=(const Ref &p_other) { replace(Ref(p_other)); }
	void operator=(Ref &&p_other) noexcept { std::swap(_object, p_other._object); }
	template <typename Other> void operator=(const Ref<Other> &p_other) { replace(Ref(p_other)); }
	void operator=(T *p_object) { replace(Ref(p_object)); }
	void operator=(const Variant &p_value) { replace(Ref(p_value)); }

	T *ptr() const { return _object; }
	T *operator->() const { return _object; }
	T *operator*() const { return _object; }
	bool is_valid() const { return _object != nullptr; }
	bool is_null() const { return _object == nullptr; }
	bool operator==(const Ref &p_other) const { return _object == p_other._object; }
	bool operator!=(const Ref &p_other) const { return _object != p_other._object; }
	bool operator==(const T *p_object) const { return _object == p_object; }
	bool operator!=(const T *p_object) const { return _object != p_object; }
	bool operator<(const Ref &p_other) const { return _object < p_other._object; }
	operator Variant() const { return Variant(_object); }

	void unref() {
		if (_object) {
			// Every RefCounted has the same address as its T, even where T is only declared.
			RefCounted *counted = reinterpret_cast<RefCounted *>(_object);
			_object = nullptr;
			if (counted->unreference()) {
				memdelete(counted);
			}
		}
	}
	template <typename... Arguments> void instantiate(const Arguments &...p_arguments) { replace(Ref(memnew(T(p_arguments...)))); }
	static String get_class_static() { return T::get_class_static(); }

	// From a call that has already counted the reference it returns.
	static Ref _gde_internal_constructor(Object *p_object) {
		Ref ref;
		ref._object = reinterpret_cast<T *>(p_object);
		return ref;
	}

private:
	T *_object = nullptr;

	void share(T *p_object) {
		if (p_object && p_object->reference()) {
			_object = p_object;
		}
	}
	void begin(T *p_object) {
		if (p_object && p_object->init_ref()) {
			_object = p_object;
		}
	}
	void replace(Ref &&p_other) { std::swap(_object, p_other._object); }
};

} // namespace godot
