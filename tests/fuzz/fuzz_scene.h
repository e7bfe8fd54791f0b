// SPDX-License-Identifier: MIT
// A scene from a string of bytes: any string makes one, the same string the same one. What a fuzzer looks for trouble with.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace grass::test {

// Plays the scene; what went wrong in it, "" if nothing.
std::string play_bytes(std::span<const uint8_t> p_bytes);

} // namespace grass::test
