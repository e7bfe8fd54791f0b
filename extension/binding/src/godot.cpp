// SPDX-License-Identifier: MIT
// The library's entry: looks the engine's functions up, or says why it cannot.
#include <godot_cpp/godot.hpp>

#include <godot_cpp/classes/editor_plugin_registration.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/engine_class.hpp>
#include <godot_cpp/core/version.hpp>

#include <cstdio>

namespace godot {

namespace gdextension_interface {

GDExtensionInterfaceGetProcAddress get_proc_address = nullptr;
GDExtensionClassLibraryPtr library = nullptr;
void *token = nullptr;
GDExtensionGodotVersion2 godot_version = {};

} // namespace gdextension_interface

namespace internal {

void forget_engine_classes();

} // namespace internal

namespace engine = gdextension_interface;

namespace {

constexpr uint32_t MINIMUM_MAJOR = 4;
constexpr uint32_t MINIMUM_MINOR = 6;

GDExtensionBinding::Callback initializer = nullptr;
GDExtensionBinding::Callback terminator = nullptr;
GDExtensionInitializationLevel minimum_level = GDEXTENSION_INITIALIZATION_CORE;

struct Documentation {
	int uncompressed_size = 0;
	int compressed_size = 0;
	const unsigned char *data = nullptr;
};
Documentation documentation;

// Refuses to load, with a message in the engine's log if there is one already, otherwise on standard error.
bool refuse(const char *p_text) {
	if (engine::print_error) {
		engine::print_error(p_text, __FUNCTION__, __FILE__, __LINE__, true);
	} else {
		fprintf(stderr, "ERROR: %s\n", p_text);
	}
	return false;
}

// Engines before 4.5 know only the older question.
void ask_version(uint32_t &r_major, uint32_t &r_minor) {
	auto ask = reinterpret_cast<GDExtensionInterfaceGetGodotVersion2>(engine::get_proc_address("get_godot_version2"));
	if (ask) {
		ask(&engine::godot_version);
		r_major = engine::godot_version.major;
		r_minor = engine::godot_version.minor;
		return;
	}
	auto ask_old = reinterpret_cast<GDExtensionInterfaceGetGodotVersion>(engine::get_proc_address("get_godot_version"));
	if (ask_old) {
		GDExtensionGodotVersion version;
		ask_old(&version);
		r_major = version.major;
		r_minor = version.minor;
	}
}

// Returns whether the engine's vectors are as large as ours. If not, every call with one would read or write what is beside it.
bool has_our_precision() {
	constexpr int FROM_NUMBERS = 3; // Vector3(x, y, z)
	const double x = 1.0, y = 2.0, z = 3.0;
	const GDExtensionConstTypePtr numbers[] = { &x, &y, &z };
	double room[3] = {}; // for either
	engine::variant_get_ptr_constructor(GDEXTENSION_VARIANT_TYPE_VECTOR3, FROM_NUMBERS)(room, numbers);
	Vector3 made;
	memcpy(&made, room, sizeof(made));
	return made == Vector3(1, 2, 3);
}

bool load() {
	char text[256];
	uint32_t major = 0;
	uint32_t minor = 0;
	engine::print_error = reinterpret_cast<GDExtensionInterfacePrintError>(engine::get_proc_address("print_error"));
	ask_version(major, minor);
	if (major < MINIMUM_MAJOR || (major == MINIMUM_MAJOR && minor < MINIMUM_MINOR)) {
		snprintf(text, sizeof(text), "This extension needs Godot %u.%u or newer; this is Godot %u.%u.", MINIMUM_MAJOR, MINIMUM_MINOR, major,
				minor);
		return refuse(text);
	}
	if (const char *missing = internal::load_interface(engine::get_proc_address)) {
		snprintf(text, sizeof(text), "This extension was built for Godot %d.%d; this Godot %u.%u lacks the function '%s'.",
				GODOT_VERSION_MAJOR, GODOT_VERSION_MINOR, major, minor, missing);
		return refuse(text);
	}
	if (!has_our_precision()) {
		using internal::IS_DOUBLE;
		snprintf(text, sizeof(text), "This library is for an engine in %s precision, and this one is in %s: take the library %s '.double'.",
				IS_DOUBLE ? "double" : "single", IS_DOUBLE ? "single" : "double", IS_DOUBLE ? "without" : "with");
		return refuse(text);
	}
	internal::load_builtins();
	internal::register_engine_classes();
	return true;
}

void load_documentation() {
	if (!documentation.data) {
		return;
	}
	constexpr int DEFLATE = 1; // FileAccess::COMPRESSION_DEFLATE
	PackedByteArray compressed;
	compressed.resize(documentation.compressed_size);
	memcpy(compressed.ptrw(), documentation.data, documentation.compressed_size);
	const PackedByteArray xml = compressed.decompress(documentation.uncompressed_size, DEFLATE);
	engine::editor_help_load_xml_from_utf8_chars_and_len(reinterpret_cast<const char *>(xml.ptr()), xml.size());
}

void initialize_level(void *, GDExtensionInitializationLevel p_level) {
	ClassDB::initialize(p_level);
	if (initializer) {
		initializer(static_cast<ModuleInitializationLevel>(p_level));
	}
	if (p_level == GDEXTENSION_INITIALIZATION_EDITOR) {
		load_documentation();
	}
}

void deinitialize_level(void *, GDExtensionInitializationLevel p_level) {
	if (terminator) {
		terminator(static_cast<ModuleInitializationLevel>(p_level));
	}
	EditorPlugins::deinitialize(p_level);
	ClassDB::deinitialize(p_level);
	if (p_level == GDEXTENSION_INITIALIZATION_CORE) {
		internal::free_singletons();
		internal::forget_engine_classes();
	}
}

} // namespace

internal::DocDataRegistration::DocDataRegistration(
		const char *, int p_uncompressed_size, int p_compressed_size, const unsigned char *p_data) {
	documentation = { p_uncompressed_size, p_compressed_size, p_data };
}

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library,
		GDExtensionInitialization *r_initialization) :
		_get_proc_address(p_get_proc_address), _library(p_library), _initialization(r_initialization) {}

void GDExtensionBinding::InitObject::register_initializer(Callback p_callback) const {
	initializer = p_callback;
}
void GDExtensionBinding::InitObject::register_terminator(Callback p_callback) const {
	terminator = p_callback;
}
void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	minimum_level = static_cast<GDExtensionInitializationLevel>(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	engine::get_proc_address = _get_proc_address;
	engine::library = _library;
	engine::token = _library;
	if (!load()) {
		return false;
	}
	_initialization->initialize = &initialize_level;
	_initialization->deinitialize = &deinitialize_level;
	_initialization->minimum_initialization_level = minimum_level;
	return true;
}

} // namespace godot
