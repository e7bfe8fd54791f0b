// SPDX-License-Identifier: MIT
// The C++ form of the shader records that shaders/base declares, in namespace grass and with the layout of std430. Includes neither Godot
// nor Eigen, so that any file may include it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace grass {

struct alignas(16) vec4 {
	float x = 0.0f, y = 0.0f, z = 0.0f, w = 0.0f;
	constexpr bool operator==(const vec4 &) const = default;
};

struct alignas(16) ivec4 {
	int32_t x = 0, y = 0, z = 0, w = 0;
	constexpr bool operator==(const ivec4 &) const = default;
};

struct alignas(16) uvec4 {
	uint32_t x = 0, y = 0, z = 0, w = 0;
	constexpr bool operator==(const uvec4 &) const = default;
};

#include "base/constants.inc"
#include "base/structs.inc"

// Returns how far knot p_knot is from the root along the blade, as a share of its length.
constexpr double knot_share(int p_knot) {
	return p_knot == 0 ? 0.0 : GRASS_CLAMP_SHARE + (p_knot - 1) * GRASS_SEGMENT_SHARE;
}
// Returns the length of a segment as a share of the blade's.
constexpr double segment_share(int p_segment) {
	return p_segment == 0 ? GRASS_CLAMP_SHARE : GRASS_SEGMENT_SHARE;
}

// Every member is one 16-byte vector, so member n of a record is at offset 16 n, in std430 and here.
static_assert(sizeof(vec4) == 16 && sizeof(ivec4) == 16 && sizeof(uvec4) == 16);

static_assert(sizeof(GrassSlot) == 64 && std::is_trivially_copyable_v<GrassSlot>);
static_assert(offsetof(GrassSlot, tile) == 0);
static_assert(offsetof(GrassSlot, list) == 16);
static_assert(offsetof(GrassSlot, blend) == 32);
static_assert(offsetof(GrassSlot, group) == 48);

static_assert(sizeof(GrassCollider) == 96 && std::is_trivially_copyable_v<GrassCollider>);
static_assert(offsetof(GrassCollider, anchor) == 0);
static_assert(offsetof(GrassCollider, position) == 16);
static_assert(offsetof(GrassCollider, rotation) == 32);
static_assert(offsetof(GrassCollider, position_before) == 48);
static_assert(offsetof(GrassCollider, rotation_before) == 64);
static_assert(offsetof(GrassCollider, size) == 80);

static_assert(sizeof(GrassForce) == 80 && std::is_trivially_copyable_v<GrassForce>);
static_assert(offsetof(GrassForce, anchor) == 0);
static_assert(offsetof(GrassForce, place) == 16);
static_assert(offsetof(GrassForce, blow) == 32);
static_assert(offsetof(GrassForce, ring) == 48);
static_assert(offsetof(GrassForce, beat) == 64);

static_assert(sizeof(GrassStep) == 128 && std::is_trivially_copyable_v<GrassStep>);
static_assert(sizeof(GrassStep) <= 128, "a push constant may be no larger everywhere");
static_assert(offsetof(GrassStep, pbd_motion) == 0);
static_assert(offsetof(GrassStep, load) == 16);
static_assert(offsetof(GrassStep, contact) == 32);
static_assert(offsetof(GrassStep, chain) == 48);
static_assert(offsetof(GrassStep, energy) == 64);
static_assert(offsetof(GrassStep, field) == 80);
static_assert(offsetof(GrassStep, clump) == 96);
static_assert(offsetof(GrassStep, free_motion) == 112);

static_assert(sizeof(GrassCamera) == 128 && std::is_trivially_copyable_v<GrassCamera>);
static_assert(offsetof(GrassCamera, planes) == 0);
static_assert(offsetof(GrassCamera, eye) == 96);
static_assert(offsetof(GrassCamera, pixel) == 112);

static_assert(sizeof(GrassView) == 160 && std::is_trivially_copyable_v<GrassView>);
static_assert(offsetof(GrassView, lod) == 0);
static_assert(offsetof(GrassView, field) == 16);
static_assert(offsetof(GrassView, blades) == 32);
static_assert(offsetof(GrassView, shadow) == 48);
static_assert(offsetof(GrassView, falls) == 64);
static_assert(offsetof(GrassView, counts) == 128);
static_assert(offsetof(GrassView, levels) == 144);

} // namespace grass
