// SPDX-License-Identifier: MIT
// The extension's entry: what the library's one exported function makes and fills.
#pragma once

#include <godot_cpp/core/gdextension_interface_loader.hpp>

namespace godot {

namespace gdextension_interface {

extern GDExtensionInterfaceGetProcAddress get_proc_address;
extern GDExtensionClassLibraryPtr library;
extern void *token; // marks the object wrappers that are ours
extern GDExtensionGodotVersion2 godot_version; // of the running engine

} // namespace gdextension_interface

namespace internal {

// Class documentation for the editor's help: XML, deflated. The data must outlive the library's initialisation.
class DocDataRegistration {
public:
	DocDataRegistration(const char *p_hash, int p_uncompressed_size, int p_compressed_size, const unsigned char *p_data);
};

} // namespace internal

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR,
	MODULE_INITIALIZATION_LEVEL_MAX,
};

class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel p_level);

	// Fill one in the library's entry function and return its init().
	class InitObject {
	public:
		InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library,
				GDExtensionInitialization *r_initialization);

		void register_initializer(Callback p_callback) const;
		void register_terminator(Callback p_callback) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const;

		// False, with an error in the log, where the engine is older than what the extension was built for.
		GDExtensionBool init() const;

	private:
		GDExtensionInterfaceGetProcAddress _get_proc_address;
		GDExtensionClassLibraryPtr _library;
		GDExtensionInitialization *_initialization;
	};
};

} // namespace godot
