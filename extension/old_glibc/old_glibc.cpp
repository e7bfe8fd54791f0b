// SPDX-License-Identifier: MIT
// Provides what libstdc++ expects of a newer C library than the one that the library must load on (glibc 2.31). Only in the library, and
// only if it is linked against that one: tools/build/platforms.py.
#include <unistd.h>

// Whether the program has a single thread, so that reference counts need no atomic instructions. Always false here.
extern "C" __attribute__((visibility("hidden"))) char __libc_single_threaded;
char __libc_single_threaded = 0;

// Returns a random number: the source of std::random_device.
extern "C" __attribute__((visibility("hidden"))) unsigned arc4random() noexcept {
	unsigned value = 0;
	return getentropy(&value, sizeof(value)) == 0 ? value : 0;
}
