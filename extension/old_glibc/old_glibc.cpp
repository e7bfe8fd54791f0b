// SPDX-License-Identifier: MIT
// What libstdc++ expects of a newer C library than the one that the library must load on (glibc 2.31). Only in the library, and only
// where it is linked against that one: tools/build/platforms.py.
#include <unistd.h>

// Whether the program has one thread only, so that reference counts need no atomic instructions: it never says so.
extern "C" __attribute__((visibility("hidden"))) char __libc_single_threaded;
char __libc_single_threaded = 0;

// What std::random_device reads.
extern "C" __attribute__((visibility("hidden"))) unsigned arc4random() noexcept {
	unsigned value = 0;
	return getentropy(&value, sizeof(value)) == 0 ? value : 0;
}
