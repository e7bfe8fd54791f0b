// SPDX-License-Identifier: MIT
#include "shared/keep_loaded.h"

#if defined(_WIN32)
#include <windows.h>
#elif !defined(__EMSCRIPTEN__) // where nothing is ever unloaded
#include <dlfcn.h>
#endif

namespace grass {

void keep_library_loaded() {
#if defined(_WIN32)
	HMODULE library = nullptr;
	const DWORD how = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_PIN;
	GetModuleHandleExW(how, reinterpret_cast<LPCWSTR>(&keep_library_loaded), &library);
#elif !defined(__EMSCRIPTEN__)
	Dl_info library = {};
	if (dladdr(reinterpret_cast<const void *>(&keep_library_loaded), &library) != 0) {
		dlopen(library.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE); // is loaded already, and is never closed
	}
#endif
}

} // namespace grass
