// SPDX-License-Identifier: MIT
// Loads a library of GDExtension, initialises all levels, prints what it registered in an order that is always the same, and takes all
// levels back again. Usage: host LIBRARY ENTRY_SYMBOL [far|game]
// With `far` it calls methods with vectors far from the origin instead of printing; with `game` it leaves the editor's level out.
#include "host.h"

#include <cstdio>
#include <cstdlib>

#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace host {

namespace {

using Entry = GDExtensionInitializationFunction;

Entry load(const char *p_library, const char *p_symbol) {
#if defined(_WIN32)
	_setmode(_fileno(stdout), _O_BINARY); // lines end alike everywhere
	HMODULE library = LoadLibraryA(p_library);
	if (!library) {
		std::fprintf(stderr, "%s does not load: error %lu\n", p_library, GetLastError());
		return nullptr;
	}
	return reinterpret_cast<Entry>(reinterpret_cast<void *>(GetProcAddress(library, p_symbol)));
#else
	void *library = dlopen(p_library, RTLD_NOW | RTLD_LOCAL);
	if (!library) {
		std::fprintf(stderr, "%s\n", dlerror());
		return nullptr;
	}
	return reinterpret_cast<Entry>(dlsym(library, p_symbol));
#endif
}

int errors = 0; // that the library reported

void report(const char *p_description, const char *p_message, const char *p_function, const char *p_file, int32_t p_line) {
	std::fprintf(stderr, "%s %s in %s, %s:%d\n", p_description, p_message, p_function, p_file, p_line);
	errors++;
}

void offer_reports(Functions &r_functions) {
	const auto plain = +[](const char *p_description, const char *p_function, const char *p_file, int32_t p_line, GDExtensionBool) {
		report(p_description, "", p_function, p_file, p_line);
	};
	const auto with_message = +[](const char *p_description, const char *p_message, const char *p_function, const char *p_file,
									   int32_t p_line, GDExtensionBool) { report(p_description, p_message, p_function, p_file, p_line); };
	for (const char *kind : { "print_error", "print_warning" }) {
		offer(r_functions, kind, plain);
		offer(r_functions, (std::string(kind) + "_with_message").c_str(), with_message);
	}
}

Functions all_functions() {
	Functions functions;
	offer_values(functions);
	offer_lists(functions);
	offer_texts(functions);
	offer_objects(functions);
	offer_registry(functions);
	offer_reports(functions);
	offer(
			functions, "get_godot_version2", +[](GDExtensionGodotVersion2 *r_version) {
				*r_version = { 4, 6, 0, 0x040600, "stable", "host", "", 0, "4.6.stable.host" };
			});
	offer(
			functions, "register_main_loop_callbacks", +[](GDExtensionClassLibraryPtr, const GDExtensionMainLoopCallbacks *) {});
	return functions;
}

// Every function of the interface is there, but most only say that they are not.
std::vector<std::string> missing;
template <int INDEX> void say_missing() {
	lack(missing[INDEX]);
}
constexpr int MOST_MISSING = 256;
template <int... ALL> GDExtensionInterfaceFunctionPtr stand_in(size_t p_index, std::integer_sequence<int, ALL...>) {
	static const GDExtensionInterfaceFunctionPtr stand_ins[] = { &say_missing<ALL>... };
	return stand_ins[p_index];
}

GDExtensionInterfaceFunctionPtr find_function(const char *p_name) {
	static const Functions functions = all_functions();
	const auto found = functions.find(p_name);
	if (found != functions.end()) {
		return found->second;
	}
	if (missing.size() == MOST_MISSING) {
		lack("room for so many functions");
	}
	missing.push_back(p_name);
	return stand_in(missing.size() - 1, std::make_integer_sequence<int, MOST_MISSING>());
}

int run(const char *p_library, const char *p_symbol, const std::string &p_how) {
	const bool is_far = p_how == "far";
	const int levels = p_how == "game" ? int(GDEXTENSION_INITIALIZATION_EDITOR) : int(GDEXTENSION_MAX_INITIALIZATION_LEVEL);
	const Entry entry = load(p_library, p_symbol);
	if (!entry) {
		std::fprintf(stderr, "There is no %s in %s.\n", p_symbol, p_library);
		return 1;
	}
	GDExtensionInitialization library = {};
	int token = 0;
	if (!entry(&find_function, &token, &library)) {
		std::fprintf(stderr, "The library refuses to be initialised.\n");
		return 1;
	}
	if (!is_far) {
		std::printf("from level %d\n", library.minimum_initialization_level);
	}
	for (int level = library.minimum_initialization_level; level < levels; level++) {
		library.initialize(library.userdata, GDExtensionInitializationLevel(level));
	}
	if (is_far) {
		errors += check_far();
	} else {
		print_registry();
	}
	for (int level = levels - 1; level >= int(library.minimum_initialization_level); level--) {
		library.deinitialize(library.userdata, GDExtensionInitializationLevel(level));
	}
	if (!is_registry_empty()) {
		std::fprintf(stderr, "Classes stayed registered.\n");
		return 1;
	}
	if (errors) {
		std::fprintf(stderr, "The library reported %d errors.\n", errors);
		return 1;
	}
	std::fflush(stdout);
	return 0;
}

} // namespace

void lack(const std::string &p_what) {
	std::fflush(stdout);
	std::fprintf(stderr, "The library needs what this host lacks: %s\n", p_what.c_str());
	std::_Exit(2);
}

} // namespace host

int main(int p_count, char **p_arguments) {
	const std::string how = p_count == 4 ? p_arguments[3] : "";
	if (p_count < 3 || p_count > 4 || (p_count == 4 && how != "far" && how != "game")) {
		std::fprintf(stderr, "Usage: host LIBRARY ENTRY_SYMBOL [far|game]\n");
		return 2;
	}
	return host::run(p_arguments[1], p_arguments[2], how);
}
