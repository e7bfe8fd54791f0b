// SPDX-License-Identifier: MIT
// The build includes it before each file of tests: a failed CHECK prints at most a few lines of a value, not all of a patch.
#pragma once

namespace grass::test {

template <class String> String shortened(const String &p_text) {
	constexpr unsigned MOST = 200; // characters
	return p_text.size() <= MOST ? p_text : p_text.substr(0, MOST) + "...";
}

} // namespace grass::test

#define DOCTEST_STRINGIFY(...) ::grass::test::shortened(toString(__VA_ARGS__))
