// SPDX-License-Identifier: MIT
// Goes into the engine before the address sanitizer. The engine opens extensions with RTLD_DEEPBIND, which the sanitizer refuses:
// such a library would find the C library's malloc before the sanitizer's.
#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) void *dlopen(const char *p_file, int p_mode) noexcept {
	using Open = void *(*)(const char *, int);
	static const Open next = reinterpret_cast<Open>(dlsym(RTLD_NEXT, "dlopen"));
	return next(p_file, p_mode & ~RTLD_DEEPBIND);
}
