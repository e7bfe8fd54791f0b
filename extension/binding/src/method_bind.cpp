// SPDX-License-Identifier: MIT
#include <godot_cpp/core/method_bind.hpp>

#include <godot_cpp/variant/callable_method_pointer.hpp>

namespace godot::internal {

void MethodBind::call(
		void *p_instance, const Variant *const *p_arguments, int64_t p_count, Variant &r_result, GDExtensionCallError &r_error) const {
	const int64_t wanted = static_cast<int64_t>(arguments.size());
	const int64_t missing = wanted - p_count;
	r_error.error = GDEXTENSION_CALL_OK;
	if (missing < 0) {
		r_error.error = GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
		r_error.expected = static_cast<int32_t>(wanted);
		return;
	}
	if (missing > static_cast<int64_t>(defaults.size())) {
		r_error.error = GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS;
		r_error.expected = static_cast<int32_t>(wanted);
		return;
	}
	if (missing == 0) {
		call_complete(p_instance, p_arguments, r_result, r_error);
		return;
	}
	const Variant *complete[MAX_ARGUMENTS];
	for (int64_t i = 0; i < wanted; i++) {
		complete[i] = i < p_count ? p_arguments[i] : &defaults[defaults.size() - static_cast<size_t>(wanted - i)];
	}
	call_complete(p_instance, complete, r_result, r_error);
}

void mark_argument(GDExtensionVariantType p_type, int p_index, GDExtensionCallError &r_error) {
	r_error.error = GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT;
	r_error.argument = p_index;
	r_error.expected = p_type;
}

void check_argument(const Variant &p_value, GDExtensionVariantType p_type, int p_index, GDExtensionCallError &r_error) {
	const GDExtensionVariantType given = static_cast<GDExtensionVariantType>(p_value.get_type());
	if (p_type != GDEXTENSION_VARIANT_TYPE_NIL && given != p_type && !gdextension_interface::variant_can_convert_strict(given, p_type)) {
		mark_argument(p_type, p_index, r_error);
	}
}

bool check_argument_count(int64_t p_count, int64_t p_expected, GDExtensionCallError &r_error) {
	r_error.error = p_count > p_expected ? GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS
										 : (p_count < p_expected ? GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS : GDEXTENSION_CALL_OK);
	r_error.expected = static_cast<int32_t>(p_expected);
	return p_count == p_expected;
}

namespace {

const CallableMethod *method_of(void *p_data) {
	return static_cast<const CallableMethod *>(p_data);
}

int compare(const CallableMethod *p_a, const CallableMethod *p_b) {
	if (p_a->identity_size != p_b->identity_size) {
		return p_a->identity_size < p_b->identity_size ? -1 : 1;
	}
	return memcmp(p_a->identity, p_b->identity, p_a->identity_size);
}

// Hashes by FNV-1a.
uint32_t hash_of(const CallableMethod *p_method) {
	const unsigned char *bytes = static_cast<const unsigned char *>(p_method->identity);
	uint32_t hash = 2166136261u;
	for (size_t i = 0; i < p_method->identity_size; i++) {
		hash = (hash ^ bytes[i]) * 16777619u;
	}
	return hash;
}

} // namespace

Callable make_callable(CallableMethod *p_method) {
	GDExtensionCallableCustomInfo2 info = {};
	info.callable_userdata = p_method;
	info.token = gdextension_interface::token;
	info.object_id = p_method->object_id;
	info.call_func = [](void *p_data, const GDExtensionConstVariantPtr *p_arguments, GDExtensionInt p_count, GDExtensionVariantPtr r_result,
							 GDExtensionCallError *r_error) {
		method_of(p_data)->call(
				reinterpret_cast<const Variant *const *>(p_arguments), p_count, *static_cast<Variant *>(r_result), *r_error);
	};
	info.is_valid_func = [](void *p_data) -> GDExtensionBool {
		const uint64_t id = method_of(p_data)->object_id;
		return id == 0 || gdextension_interface::object_get_instance_from_id(id);
	};
	info.free_func = [](void *p_data) { memdelete(static_cast<CallableMethod *>(p_data)); };
	info.hash_func = [](void *p_data) { return hash_of(method_of(p_data)); };
	info.equal_func = [](void *p_a, void *p_b) -> GDExtensionBool { return compare(method_of(p_a), method_of(p_b)) == 0; };
	info.less_than_func = [](void *p_a, void *p_b) -> GDExtensionBool { return compare(method_of(p_a), method_of(p_b)) < 0; };
	info.get_argument_count_func = [](void *p_data, GDExtensionBool *r_valid) -> GDExtensionInt {
		*r_valid = true;
		return method_of(p_data)->argument_count;
	};
	Callable callable;
	gdextension_interface::callable_custom_create2(callable._native_ptr(), &info);
	return callable;
}

} // namespace godot::internal
