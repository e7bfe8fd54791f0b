// SPDX-License-Identifier: MIT
// The stress tests' main(): doctest brings it.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
