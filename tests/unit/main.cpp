// SPDX-License-Identifier: MIT
// main() of the unit and the stress tests: doctest brings it. Tests of core/NAME stand in test_NAME.cpp.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
