// SPDX-License-Identifier: MIT
// memnew and memdelete: memory from the engine's allocator, and objects that the engine knows.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/godot.hpp>

#include <new>
#include <type_traits>

namespace godot {

class Wrapped;

namespace Memory {

void *alloc_static(size_t p_bytes, bool p_pad_align = false);
void free_static(void *p_memory, bool p_pad_align = false);

} // namespace Memory

struct DefaultAllocator {
	static void free(void *p_memory) { Memory::free_static(p_memory); }
};

namespace internal {

// The two halves of memnew around the construction itself. For classes that the engine knows the first says which
// object the base Wrapped shall make (class_hooks.hpp), the second sends NOTIFICATION_POSTINITIALIZE.
template <typename T> void prepare_object();
void after_construction(Wrapped *p_object);

template <typename T> void before_construction() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		prepare_object<T>();
	}
}

template <typename T> T *finish_construction(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		after_construction(p_object);
	}
	return p_object;
}

void destroy_object(Wrapped *p_object);

} // namespace internal

template <typename T> void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		internal::destroy_object(p_object);
	} else {
		p_object->~T();
		Memory::free_static(p_object);
	}
}

} // namespace godot

// The parameter only selects this overload.
void *operator new(size_t p_bytes, ::godot::DefaultAllocator);
void operator delete(void *p_memory, ::godot::DefaultAllocator);

#define memnew(m_class)                                                                                                                    \
	(::godot::internal::before_construction<std::remove_pointer_t<decltype(new (::godot::DefaultAllocator{}) m_class)>>(),                 \
			::godot::internal::finish_construction(new (::godot::DefaultAllocator{}) m_class))
