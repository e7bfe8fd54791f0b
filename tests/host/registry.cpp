// SPDX-License-Identifier: MIT
// What the library registers: heard, and printed.
#include "host.h"

#include <algorithm>
#include <cstdio>

namespace host {

namespace {

struct Property {
	std::string line, getter;
	int index;
};

struct Class {
	std::string head;
	GDExtensionClassCreationInfo5 info;
	bool is_registered = true;
	std::vector<std::string> lines; // methods, signals, constants, groups
	std::map<std::string, GDExtensionClassMethodInfo> methods;
	std::vector<Property> properties;
};
std::map<std::string, Class> classes; // by name, so the order is always the same
std::vector<std::string> editor_lines;

Class &class_named(GDExtensionConstStringNamePtr p_name) {
	return classes.at(name_text(p_name));
}

std::string describe(const GDExtensionPropertyInfo &p_info) {
	const std::string class_name = name_text(p_info.class_name), hint = string_text(p_info.hint_string);
	return name_text(p_info.name) + ": " + TYPE_NAMES[p_info.type] + (class_name.empty() ? "" : " " + class_name) + " hint " +
			std::to_string(p_info.hint) + (hint.empty() ? "" : " \"" + hint + "\"") + " usage " + std::to_string(p_info.usage);
}

std::string describe(const GDExtensionPropertyInfo *p_arguments, size_t p_count) {
	std::string text;
	for (size_t i = 0; i < p_count; i++) {
		text += (i ? "; " : "") + describe(p_arguments[i]);
	}
	return "(" + text + ")";
}

void register_class(GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_name, GDExtensionConstStringNamePtr p_parent,
		const GDExtensionClassCreationInfo5 *p_info) {
	const std::string icon = string_text(p_info->icon_path);
	std::string head = "class " + name_text(p_name) + " : " + name_text(p_parent);
	for (const auto &[flag, word] : { std::pair(p_info->is_virtual, "virtual"), std::pair(p_info->is_abstract, "abstract"),
				 std::pair(p_info->is_exposed, "exposed"), std::pair(p_info->is_runtime, "runtime") }) {
		head += flag ? std::string(" ") + word : "";
	}
	Class &entry = classes[name_text(p_name)];
	entry.head = head + (icon.empty() ? "" : " icon " + icon);
	entry.info = *p_info;
}

void register_method(GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class, const GDExtensionClassMethodInfo *p_info) {
	std::string line = "method " + name_text(p_info->name) + describe(p_info->arguments_info, p_info->argument_count);
	for (uint32_t i = 0; i < p_info->argument_count; i++) {
		line += (i ? " " : " metadata ") + std::to_string(p_info->arguments_metadata[i]);
	}
	for (uint32_t i = 0; i < p_info->default_argument_count; i++) {
		line += (i ? ", " : " defaults ") + print(*static_cast<const Variant *>(p_info->default_arguments[i]));
	}
	if (p_info->has_return_value) {
		line += " -> " + describe(*p_info->return_value_info) + " metadata " + std::to_string(p_info->return_value_metadata);
	}
	Class &owner = class_named(p_class);
	owner.lines.push_back(line + " flags " + std::to_string(p_info->method_flags));
	owner.methods[name_text(p_info->name)] = *p_info;
}

void register_property(GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class, const GDExtensionPropertyInfo *p_info,
		GDExtensionConstStringNamePtr p_setter, GDExtensionConstStringNamePtr p_getter, GDExtensionInt p_index) {
	const std::string line = "property " + describe(*p_info) + " set " + name_text(p_setter) + " get " + name_text(p_getter) + " index " +
			std::to_string(p_index);
	class_named(p_class).properties.push_back({ line, name_text(p_getter), int(p_index) });
}

void register_signal(GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class, GDExtensionConstStringNamePtr p_name,
		const GDExtensionPropertyInfo *p_arguments, GDExtensionInt p_count) {
	class_named(p_class).lines.push_back("signal " + name_text(p_name) + describe(p_arguments, size_t(p_count)));
}

void register_constant(GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class, GDExtensionConstStringNamePtr p_enum,
		GDExtensionConstStringNamePtr p_name, GDExtensionInt p_value, GDExtensionBool p_is_bitfield) {
	class_named(p_class).lines.push_back("constant " + name_text(p_enum) + "." + name_text(p_name) + " = " + std::to_string(p_value) +
			(p_is_bitfield ? " bit field" : ""));
}

// A property's default is what a new object's getter says, as in the engine.
std::string default_of(const Class &p_class, const Property &p_property, void *p_instance) {
	const auto getter = p_class.methods.find(p_property.getter);
	if (!p_instance || getter == p_class.methods.end()) {
		return "";
	}
	Variant index, result = {};
	const int64_t value = p_property.index;
	set_value(index, GDEXTENSION_VARIANT_TYPE_INT, &value);
	const GDExtensionConstVariantPtr arguments[] = { &index };
	GDExtensionCallError error = {};
	const GDExtensionClassMethodInfo &method = getter->second;
	method.call_func(method.method_userdata, p_instance, arguments, p_property.index >= 0 ? 1 : 0, &result, &error);
	return error.error == GDEXTENSION_CALL_OK ? " default " + print(result) : " no default: call error " + std::to_string(error.error);
}

} // namespace

bool construct_registered(Name p_class, Object *&r_object) {
	const auto found = classes.find(p_class ? *p_class : "");
	if (found == classes.end() || !found->second.info.create_instance_func) {
		return false;
	}
	r_object = static_cast<Object *>(found->second.info.create_instance_func(found->second.info.class_userdata, true));
	return true;
}

const GDExtensionClassMethodInfo *find_registered(const std::string &p_class, const std::string &p_method) {
	const auto found = classes.find(p_class);
	if (found == classes.end()) {
		return nullptr;
	}
	const auto method = found->second.methods.find(p_method);
	return method == found->second.methods.end() ? nullptr : &method->second;
}

void print_registry() {
	for (const auto &[name, entry] : classes) {
		std::printf("%s\n", entry.head.c_str());
		Object *object = nullptr;
		if (entry.info.is_exposed && !entry.info.is_abstract) {
			construct_registered(make_name(name), object);
		}
		std::vector<std::string> lines = entry.lines;
		for (const Property &property : entry.properties) {
			lines.push_back(property.line + default_of(entry, property, object ? object->instance : nullptr));
		}
		std::sort(lines.begin(), lines.end());
		for (const std::string &line : lines) {
			std::printf("\t%s\n", line.c_str());
		}
	}
	for (const std::string &line : editor_lines) {
		std::printf("%s\n", line.c_str());
	}
}

bool is_registry_empty() {
	return std::none_of(classes.begin(), classes.end(), [](const auto &p_entry) { return p_entry.second.is_registered; });
}

void offer_registry(Functions &r_functions) {
	offer(r_functions, "classdb_register_extension_class5", &register_class);
	offer(r_functions, "classdb_register_extension_class_method", &register_method);
	offer(r_functions, "classdb_register_extension_class_property_indexed", &register_property);
	offer(r_functions, "classdb_register_extension_class_signal", &register_signal);
	offer(r_functions, "classdb_register_extension_class_integer_constant", &register_constant);
	const auto group = +[](GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class, GDExtensionConstStringPtr p_name,
								GDExtensionConstStringPtr p_prefix) {
		class_named(p_class).lines.push_back("group \"" + string_text(p_name) + "\" prefix \"" + string_text(p_prefix) + "\"");
	};
	offer(r_functions, "classdb_register_extension_class_property_group", group);
	offer(r_functions, "classdb_register_extension_class_property_subgroup", group);
	offer(
			r_functions, "classdb_unregister_extension_class",
			+[](GDExtensionClassLibraryPtr, GDExtensionConstStringNamePtr p_class) { class_named(p_class).is_registered = false; });
	offer(
			r_functions, "editor_add_plugin",
			+[](GDExtensionConstStringNamePtr p_class) { editor_lines.push_back("editor plugin " + name_text(p_class)); });
	offer(
			r_functions, "editor_remove_plugin", +[](GDExtensionConstStringNamePtr) {});
	offer(
			r_functions, "editor_help_load_xml_from_utf8_chars_and_len", +[](const char *p_text, GDExtensionInt p_size) {
				uint32_t sum = 0;
				for (GDExtensionInt i = 0; i < p_size; i++) {
					sum = sum * 31 + static_cast<unsigned char>(p_text[i]);
				}
				editor_lines.push_back("editor help of " + std::to_string(p_size) + " bytes, sum " + std::to_string(sum));
			});
}

} // namespace host
