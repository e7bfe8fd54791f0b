// SPDX-License-Identifier: MIT
// Methods of engine classes that stand in the C interface instead of the API dump.
#include <godot_cpp/core/object.hpp>
#if __has_include(<godot_cpp/classes/image.hpp>)
#include <godot_cpp/classes/image.hpp>
#define HAS_IMAGE
#endif
#if __has_include(<godot_cpp/classes/file_access.hpp>)
#include <godot_cpp/classes/file_access.hpp>
#define HAS_FILE_ACCESS
#endif
#if __has_include(<godot_cpp/classes/worker_thread_pool.hpp>)
#include <godot_cpp/classes/worker_thread_pool.hpp>
#define HAS_WORKER_THREAD_POOL
#endif

namespace godot {

#ifdef HAS_IMAGE
uint8_t *Image::ptrw() {
	return gdextension_interface::image_ptrw(_owner);
}
const uint8_t *Image::ptr() {
	return gdextension_interface::image_ptr(_owner);
}
#endif

#ifdef HAS_FILE_ACCESS
uint64_t FileAccess::get_buffer(uint8_t *p_bytes, uint64_t p_length) const {
	return gdextension_interface::file_access_get_buffer(_owner, p_bytes, p_length);
}
void FileAccess::store_buffer(const uint8_t *p_bytes, uint64_t p_length) {
	gdextension_interface::file_access_store_buffer(_owner, p_bytes, p_length);
}
#endif

#ifdef HAS_WORKER_THREAD_POOL
int64_t WorkerThreadPool::add_native_task(void (*p_function)(void *), void *p_data, bool p_high_priority, const String &p_description) {
	return gdextension_interface::worker_thread_pool_add_native_task(
			_owner, p_function, p_data, p_high_priority, p_description._native_ptr());
}
int64_t WorkerThreadPool::add_native_group_task(void (*p_function)(void *, uint32_t), void *p_data, int p_elements, int p_tasks,
		bool p_high_priority, const String &p_description) {
	return gdextension_interface::worker_thread_pool_add_native_group_task(
			_owner, p_function, p_data, p_elements, p_tasks, p_high_priority, p_description._native_ptr());
}
#endif

} // namespace godot
