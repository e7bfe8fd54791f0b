// SPDX-License-Identifier: MIT
// The unit tests' main(): doctest brings it. Tests of core/NAME stand in test_NAME.cpp.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
