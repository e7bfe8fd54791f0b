// SPDX-License-Identifier: MIT
#include <godot_cpp/core/class_db.hpp>

#include <memory>
#include <unordered_map>

namespace godot {

namespace engine = gdextension_interface;

namespace {

struct VirtualMethod {
	GDExtensionClassCallVirtual call;
	uint32_t hash;
};

// One class of the extension.
struct ClassRecord {
	StringName name;
	ClassRecord *parent = nullptr; // null where the base is the engine's
	GDExtensionInitializationLevel level;
	std::unordered_map<StringName, std::unique_ptr<internal::MethodBind>, internal::StringNameHash> methods;
	std::unordered_map<StringName, VirtualMethod, internal::StringNameHash> virtuals;
};

// In the order of registration. Made with the first class, gone with the last.
std::vector<std::unique_ptr<ClassRecord>> classes;
GDExtensionInitializationLevel current_level = GDEXTENSION_INITIALIZATION_CORE;

ClassRecord *find_class(const StringName &p_name) {
	for (const std::unique_ptr<ClassRecord> &record : classes) {
		if (record->name == p_name) {
			return record.get();
		}
	}
	return nullptr;
}

GDExtensionClassCallVirtual find_virtual(void *p_class, GDExtensionConstStringNamePtr p_name, uint32_t p_hash) {
	const StringName &name = *static_cast<const StringName *>(p_name);
	for (ClassRecord *record = static_cast<ClassRecord *>(p_class); record; record = record->parent) {
		auto found = record->virtuals.find(name);
		if (found != record->virtuals.end()) {
			return found->second.hash == p_hash ? found->second.call : nullptr;
		}
	}
	return nullptr;
}

void call_method(void *p_bind, GDExtensionClassInstancePtr p_instance, const GDExtensionConstVariantPtr *p_arguments,
		GDExtensionInt p_count, GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	const Variant *const *arguments = reinterpret_cast<const Variant *const *>(p_arguments);
	static_cast<internal::MethodBind *>(p_bind)->call(p_instance, arguments, p_count, *static_cast<Variant *>(r_result), *r_error);
}

void call_method_pointers(
		void *p_bind, GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
	static_cast<internal::MethodBind *>(p_bind)->call_pointers(p_instance, p_arguments, r_result);
}

void tell_engine(const internal::MethodBind &p_method) {
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &info : p_method.arguments) {
		arguments.push_back(info._to_gdextension());
	}
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata = p_method.argument_metadata;
	std::vector<GDExtensionVariantPtr> defaults;
	for (const Variant &value : p_method.defaults) {
		defaults.push_back(value._native_ptr());
	}
	GDExtensionPropertyInfo result = p_method.result._to_gdextension();
	GDExtensionClassMethodInfo info = {};
	info.name = p_method.name._native_ptr();
	info.method_userdata = const_cast<internal::MethodBind *>(&p_method);
	info.call_func = &call_method;
	info.ptrcall_func = &call_method_pointers;
	info.method_flags = p_method.flags;
	info.has_return_value = p_method.has_result;
	info.return_value_info = &result;
	info.return_value_metadata = p_method.result_metadata;
	info.argument_count = static_cast<uint32_t>(arguments.size());
	info.arguments_info = arguments.data();
	info.arguments_metadata = metadata.data();
	info.default_argument_count = static_cast<uint32_t>(defaults.size());
	info.default_arguments = defaults.data();
	engine::classdb_register_extension_class_method(engine::library, p_method.class_name._native_ptr(), &info);
}

internal::MethodBind *get_method(const StringName &p_class, const StringName &p_method) {
	for (ClassRecord *record = find_class(p_class); record; record = record->parent) {
		auto found = record->methods.find(p_method);
		if (found != record->methods.end()) {
			return found->second.get();
		}
	}
	return nullptr;
}

} // namespace

void ClassDB::add_class(const StringName &p_name, const StringName &p_parent, GDExtensionClassCreationInfo5 &p_info) {
	ERR_FAIL_COND_MSG(find_class(p_name), vformat("Class '%s' is registered twice.", p_name));
	auto record = std::make_unique<ClassRecord>();
	record->name = p_name;
	record->parent = find_class(p_parent);
	record->level = current_level;
	p_info.class_userdata = record.get();
	p_info.get_virtual_func = &find_virtual;
	classes.push_back(std::move(record));
	engine::classdb_register_extension_class5(engine::library, p_name._native_ptr(), p_parent._native_ptr(), &p_info);
}

void ClassDB::add_method(
		const StringName &p_class, internal::MethodBind *p_method, const MethodDefinition &p_definition, std::vector<Variant> p_defaults) {
	std::unique_ptr<internal::MethodBind> method(p_method);
	ClassRecord *record = find_class(p_class);
	ERR_FAIL_COND_MSG(!record, vformat("Method '%s' is bound to '%s', which is not registered.", p_definition.name, p_class));
	ERR_FAIL_COND_MSG(record->methods.count(p_definition.name), vformat("Method '%s::%s' is bound twice.", p_class, p_definition.name));
	const size_t most = MAX(p_definition._arguments.size(), p_defaults.size());
	ERR_FAIL_COND_MSG(most > method->arguments.size(),
			vformat("Method '%s::%s' is bound with more argument names or defaults than it has arguments.", p_class, p_definition.name));
	method->name = p_definition.name;
	method->class_name = p_class;
	method->defaults = std::move(p_defaults);
	for (size_t i = 0; i < method->arguments.size(); i++) {
		method->arguments[i].name =
				i < p_definition._arguments.size() ? p_definition._arguments[i] : StringName(vformat("arg%d", int64_t(i)));
	}
	tell_engine(*method);
	record->methods[p_definition.name] = std::move(method);
}

void ClassDB::add_property(
		const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter, const StringName &p_getter, int p_index) {
	ERR_FAIL_COND_MSG(p_setter != StringName() && !get_method(p_class, p_setter),
			vformat("Setter '%s::%s' of property '%s' is not bound.", p_class, p_setter, p_info.name));
	ERR_FAIL_COND_MSG(
			!get_method(p_class, p_getter), vformat("Getter '%s::%s' of property '%s' is not bound.", p_class, p_getter, p_info.name));
	const GDExtensionPropertyInfo info = p_info._to_gdextension();
	engine::classdb_register_extension_class_property_indexed(
			engine::library, p_class._native_ptr(), &info, p_setter._native_ptr(), p_getter._native_ptr(), p_index);
}

void ClassDB::add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix) {
	engine::classdb_register_extension_class_property_group(
			engine::library, p_class._native_ptr(), p_name._native_ptr(), p_prefix._native_ptr());
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &info : p_signal.arguments) {
		arguments.push_back(info._to_gdextension());
	}
	engine::classdb_register_extension_class_signal(engine::library, p_class._native_ptr(), p_signal.name._native_ptr(), arguments.data(),
			static_cast<GDExtensionInt>(arguments.size()));
}

void ClassDB::bind_integer_constant(
		const StringName &p_class, const StringName &p_enum, const StringName &p_name, int64_t p_value, bool p_bitfield) {
	// The engine wants the enum's own name, without its class.
	const PackedStringArray parts = String(p_enum).split(".");
	const StringName plain = parts.is_empty() ? StringName() : StringName(parts[parts.size() - 1]);
	engine::classdb_register_extension_class_integer_constant(
			engine::library, p_class._native_ptr(), plain._native_ptr(), p_name._native_ptr(), p_value, p_bitfield);
}

void ClassDB::initialize(GDExtensionInitializationLevel p_level) {
	current_level = p_level;
}

// Classes go in the opposite order of their coming: what inherits before what is inherited.
void ClassDB::deinitialize(GDExtensionInitializationLevel p_level) {
	while (!classes.empty() && classes.back()->level == p_level) {
		engine::classdb_unregister_extension_class(engine::library, classes.back()->name._native_ptr());
		classes.pop_back();
	}
}

void internal::bind_virtual_method(const StringName &p_class, const char *p_method, GDExtensionClassCallVirtual p_call, uint32_t p_hash) {
	if (ClassRecord *record = find_class(p_class)) {
		record->virtuals[StringName(p_method)] = { p_call, p_hash };
	}
}

} // namespace godot
