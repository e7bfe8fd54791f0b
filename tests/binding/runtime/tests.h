// SPDX-License-Identifier: MIT
// doctest for a library without exceptions inside of the engine, which handles signals by itself.
#pragma once

#define DOCTEST_CONFIG_NO_EXCEPTIONS_BUT_WITH_ALL_ASSERTS
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS
#include <doctest/doctest.h>
