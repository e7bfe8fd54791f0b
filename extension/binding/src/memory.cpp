// SPDX-License-Identifier: MIT
#include <godot_cpp/core/memory.hpp>

#include <godot_cpp/core/object.hpp>

namespace godot {

void *Memory::alloc_static(size_t p_bytes, bool p_pad_align) {
	return gdextension_interface::mem_alloc2(p_bytes, p_pad_align);
}

void Memory::free_static(void *p_memory, bool p_pad_align) {
	if (p_memory) {
		gdextension_interface::mem_free2(p_memory, p_pad_align);
	}
}

namespace internal {

void after_construction(Wrapped *p_object) {
	static_cast<Object *>(p_object)->notification(Object::NOTIFICATION_POSTINITIALIZE);
}

void destroy_object(Wrapped *p_object) {
	gdextension_interface::object_destroy(p_object->_owner);
}

} // namespace internal

} // namespace godot

void *operator new(size_t p_bytes, ::godot::DefaultAllocator) {
	return ::godot::Memory::alloc_static(p_bytes);
}

// Is called only when a constructor throws.
void operator delete(void *p_memory, ::godot::DefaultAllocator) {
	::godot::Memory::free_static(p_memory);
}
