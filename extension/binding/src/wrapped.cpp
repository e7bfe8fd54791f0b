// SPDX-License-Identifier: MIT
#include <godot_cpp/classes/wrapped.hpp>

#include <godot_cpp/core/object.hpp>

namespace godot {

internal::Construction &internal::next_construction() {
	static thread_local Construction construction;
	return construction;
}

Wrapped::Wrapped() {
	const internal::Construction construction = std::exchange(internal::next_construction(), {});
	if (construction.wrapped) {
		_owner = construction.wrapped;
		return;
	}
	CRASH_COND_MSG(!construction.identity, "Objects of the engine are made with memnew or instantiate().");
	const internal::ClassIdentity &identity = *construction.identity;
	_owner = construction.recreated ? construction.recreated
									: gdextension_interface::classdb_construct_object2(identity.engine_class()._native_ptr());
	if (identity.extension_class) {
		gdextension_interface::object_set_instance(_owner, identity.extension_class()._native_ptr(), this);
	}
	gdextension_interface::object_set_instance_binding(_owner, gdextension_interface::token, this, identity.callbacks);
}

} // namespace godot
