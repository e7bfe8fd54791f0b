// SPDX-License-Identifier: MIT
// A library of its own on the binding: in the engine it runs the test cases of this folder. `./grass test binding` builds and loads it.
#define DOCTEST_CONFIG_IMPLEMENT
#include "tests.h"

#include "probe.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

// What the project's script makes and runs.
class BindingTests : public RefCounted {
	GDCLASS(BindingTests, RefCounted)

public:
	// Returns how many test cases failed, by way of doctest's exit code.
	int run() {
		doctest::Context context;
		context.setOption("no-colors", true);
		return context.run();
	}

protected:
	static void _bind_methods() { ClassDB::bind_method(D_METHOD("run"), &BindingTests::run); }
};

void initialize_binding_tests(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(Probe);
		GDREGISTER_CLASS(BindingTests);
	}
}

extern "C" GDExtensionBool GDE_EXPORT binding_tests_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize_binding_tests);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
