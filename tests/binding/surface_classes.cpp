// SPDX-License-Identifier: MIT
// Objects, registration and the library's entry.
#include "surface.h"

#include <godot_cpp/classes/editor_plugin_registration.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

// core/property_info.hpp
FIELD(PropertyInfo, type, Variant::Type)
FIELD(PropertyInfo, name, StringName)
FIELD(PropertyInfo, class_name, StringName)
FIELD(PropertyInfo, hint, uint32_t)
FIELD(PropertyInfo, hint_string, String)
FIELD(PropertyInfo, usage, uint32_t)
CONSTRUCTOR(PropertyInfo)
CONSTRUCTOR(PropertyInfo, Variant::Type, const StringName &, PropertyHint, const String &, uint32_t, const StringName &)
CONSTRUCTOR(PropertyInfo, Variant::Type, const StringName &, PropertyHint, const String &, uint32_t)
CONSTRUCTOR(PropertyInfo, Variant::Type, const StringName &, PropertyHint, const String &)
CONSTRUCTOR(PropertyInfo, Variant::Type, const StringName &, PropertyHint)
CONSTRUCTOR(PropertyInfo, Variant::Type, const StringName &)
CONSTRUCTOR(PropertyInfo, GDExtensionVariantType, const StringName &, PropertyHint, const String &, uint32_t, const StringName &)
CONSTRUCTOR(PropertyInfo, GDExtensionVariantType, const StringName &, PropertyHint, const String &, uint32_t)
CONSTRUCTOR(PropertyInfo, GDExtensionVariantType, const StringName &, PropertyHint, const String &)
CONSTRUCTOR(PropertyInfo, GDExtensionVariantType, const StringName &, PropertyHint)
CONSTRUCTOR(PropertyInfo, GDExtensionVariantType, const StringName &)
CONSTRUCTOR(PropertyInfo, const GDExtensionPropertyInfo *)
METHOD(PropertyInfo, operator Dictionary, Dictionary() const)

// core/object.hpp
FIELD(MethodInfo, name, StringName)
FIELD(MethodInfo, return_val, PropertyInfo)
FIELD(MethodInfo, flags, uint32_t)
FIELD(MethodInfo, id, int)
FIELD(MethodInfo, arguments, LocalVector<PropertyInfo>)
FIELD(MethodInfo, default_arguments, LocalVector<Variant>)
CONSTRUCTOR(MethodInfo)
STATIC(ObjectDB, get_instance, Object *(uint64_t))

// core/class_db.hpp
FIELD(MethodDefinition, name, StringName)
STATIC(ClassDB, add_property, void(const StringName &, const PropertyInfo &, const StringName &, const StringName &, int))
STATIC(ClassDB, add_property_group, void(const StringName &, const String &, const String &))
STATIC(ClassDB, add_signal, void(const StringName &, const MethodInfo &))
STATIC(ClassDB, bind_integer_constant, void(const StringName &, const StringName &, const StringName &, int64_t, bool))
STATIC(ClassDB, initialize, void(GDExtensionInitializationLevel))
STATIC(ClassDB, deinitialize, void(GDExtensionInitializationLevel))

// What the C interface has beside the dump.
METHOD(Image, ptrw, uint8_t *())
METHOD(Image, ptr, const uint8_t *())
METHOD(FileAccess, get_buffer, uint64_t(uint8_t *, uint64_t) const)
METHOD(FileAccess, store_buffer, void(const uint8_t *, uint64_t))
METHOD(WorkerThreadPool, add_native_task, int64_t(void (*)(void *), void *, bool, const String &))
METHOD(WorkerThreadPool, add_native_group_task, int64_t(void (*)(void *, uint32_t), void *, int, int, bool, const String &))

// classes/editor_plugin_registration.hpp
STATIC(EditorPlugins, add_plugin_class, void(const StringName &))
STATIC(EditorPlugins, deinitialize, void(GDExtensionInitializationLevel))

// godot.hpp
VALUE(MODULE_INITIALIZATION_LEVEL_CORE, 0)
VALUE(MODULE_INITIALIZATION_LEVEL_SERVERS, 1)
VALUE(MODULE_INITIALIZATION_LEVEL_SCENE, 2)
VALUE(MODULE_INITIALIZATION_LEVEL_EDITOR, 3)
VALUE(MODULE_INITIALIZATION_LEVEL_MAX, 4)
TYPE(GDExtensionBinding::Callback, void (*)(ModuleInitializationLevel))
CONSTRUCTOR(GDExtensionBinding::InitObject, void (*(*)(const char *))(), void *, GDExtensionInitialization *)
METHOD(GDExtensionBinding::InitObject, register_initializer, void(void (*)(ModuleInitializationLevel)) const)
METHOD(GDExtensionBinding::InitObject, register_terminator, void(void (*)(ModuleInitializationLevel)) const)
METHOD(GDExtensionBinding::InitObject, set_minimum_library_initialization_level, void(ModuleInitializationLevel) const)
METHOD(GDExtensionBinding::InitObject, init, uint8_t() const)

// core/memory.hpp
FUNCTION(Memory::alloc_static, void *(uint64_t, bool))
FUNCTION(Memory::free_static, void(void *, bool))
STATIC(DefaultAllocator, free, void(void *))
