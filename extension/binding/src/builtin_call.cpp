// SPDX-License-Identifier: MIT
#include <godot_cpp/core/builtin_call.hpp>

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot::internal {

namespace engine = gdextension_interface;

BuiltinType builtin_types[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];

void load_builtins() {
	for (int i = GDEXTENSION_VARIANT_TYPE_BOOL; i < GDEXTENSION_VARIANT_TYPE_VARIANT_MAX; i++) {
		const GDExtensionVariantType type = static_cast<GDExtensionVariantType>(i);
		BuiltinType &entry = builtin_types[i];
		for (int constructor = 0; constructor < builtin_constructor_counts[i]; constructor++) {
			entry.constructors[constructor] = engine::variant_get_ptr_constructor(type, constructor);
		}
		entry.destructor = engine::variant_get_ptr_destructor(type);
		entry.to_variant = engine::get_variant_from_type_constructor(type);
		entry.from_variant = engine::get_variant_to_type_constructor(type);
	}
}

GDExtensionPtrBuiltInMethod BuiltinMethod::find() {
	GDExtensionPtrBuiltInMethod found = engine::variant_get_ptr_builtin_method(type, StringName(name)._native_ptr(), hash);
	CRASH_COND_MSG(!found, name);
	function.store(found, std::memory_order_release);
	return found;
}

GDExtensionPtrOperatorEvaluator BuiltinOperator::find() {
	GDExtensionPtrOperatorEvaluator found = engine::variant_get_ptr_operator_evaluator(operation, left, right);
	CRASH_COND(!found);
	function.store(found, std::memory_order_release);
	return found;
}

GDExtensionPtrUtilityFunction UtilityFunction::find() {
	GDExtensionPtrUtilityFunction found = engine::variant_get_ptr_utility_function(StringName(name)._native_ptr(), hash);
	CRASH_COND_MSG(!found, name);
	function.store(found, std::memory_order_release);
	return found;
}

} // namespace godot::internal
