// SPDX-License-Identifier: MIT
// A tile of blades, colliders and time, for the tests of the solver: no patch, no pool, shapes set by hand.
#pragma once

#include "core/base/functions.h"
#include "core/solver/solver_params.h"
#include "core/solver/tile_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace grass::test {

using Step = TileStep;
inline constexpr Step ALL_STEPS[] = { step_lanes, step_scalar_float, step_scalar_double };

// Both methods, for TEST_CASE_TEMPLATE.
struct Direct {
	static constexpr Method METHOD = Method::DIRECT;
};
struct Pbd {
	static constexpr Method METHOD = Method::PBD;
};

inline constexpr int SHAPES[] = { GRASS_SPHERE, GRASS_CAPSULE, GRASS_BOX, GRASS_CYLINDER, GRASS_HULL };
inline constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

// The same on every platform.
inline float sin_of(float p_angle) {
	return float(sine(double(p_angle)));
}
inline float cos_of(float p_angle) {
	return float(cosine(double(p_angle)));
}

// Returns what p_at(knot) is at a share p_share of the way from root to tip.
template <class At> Eigen::Vector3f between_knots(double p_share, const At &p_at) {
	int below = 0;
	while (below < GRASS_SEGMENTS - 1 && knot_share(below + 1) < p_share) {
		below++;
	}
	const float part = float((p_share - knot_share(below)) / segment_share(below));
	return p_at(below) * (1.0f - part) + p_at(below + 1) * part;
}

struct BladeScene {
	std::unique_ptr<TileState> tile = std::make_unique<TileState>();
	SolverParams params;
	StepClock clock;
	std::vector<GrassCollider> colliders;
	std::vector<Eigen::Vector4f> planes;
	Step step_function = step_lanes;
	float blend = 0.0f;
	float energy = 0.0f;
	float length = 0.5f; // metres, of every blade

	// Blades with their roots at the tile's centre: the first straight, the others leaning and curving ever more.
	explicit BladeScene(float p_length = 0.5f, Method p_method = Method::DIRECT) : length(p_length) {
		params.method = p_method;
		std::memset(tile.get(), 0, sizeof(TileState));
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const float curve = 1.2f * float(b) / float(GRASS_BLADES_PER_TILE), heading = 0.7f * float(b);
			tile->width[0][b] = -sin_of(heading); // it leans and curves across its width
			tile->width[1][b] = cos_of(heading);
			Eigen::Vector3f knot = Eigen::Vector3f::Zero();
			for (int k = 0; k < GRASS_KNOTS; k++) {
				set_rest(b, k, knot);
				const float angle = curve * float(knot_share(k));
				const Eigen::Vector3f way(sin_of(angle) * cos_of(heading), cos_of(angle), sin_of(angle) * sin_of(heading));
				knot += length * float(segment_share(k)) * way;
			}
		}
	}

	explicit BladeScene(Method p_method) : BladeScene(0.5f, p_method) {}

	void set_rest(int p_blade, int p_knot, const Eigen::Vector3f &p_place) {
		for (int c = 0; c < 3; c++) {
			tile->rest[c][p_knot][p_blade] = p_place[c];
		}
		set_knot(p_blade, p_knot, p_place);
	}
	// Standing still there.
	void set_knot(int p_blade, int p_knot, const Eigen::Vector3f &p_place) {
		for (int c = 0; c < 3 && p_knot >= GRASS_CLAMPED_KNOTS; c++) {
			tile->knots[c][p_knot - GRASS_CLAMPED_KNOTS][p_blade] = p_place[c];
			tile->before[c][p_knot - GRASS_CLAMPED_KNOTS][p_blade] = p_place[c];
		}
	}
	Eigen::Vector3f rest(int p_blade, int p_knot) const {
		return { tile->rest[0][p_knot][p_blade], tile->rest[1][p_knot][p_blade], tile->rest[2][p_knot][p_blade] };
	}
	Eigen::Vector3f knot(int p_blade, int p_knot) const {
		const int free = p_knot - GRASS_CLAMPED_KNOTS;
		return free < 0 ? rest(p_blade, p_knot)
						: Eigen::Vector3f(tile->knots[0][free][p_blade], tile->knots[1][free][p_blade], tile->knots[2][free][p_blade]);
	}
	// Returns the place at a share p_share of the way from root to tip.
	Eigen::Vector3f place(int p_blade, double p_share) const {
		return between_knots(p_share, [&](int p_knot) { return knot(p_blade, p_knot); });
	}

	// Bends every blade to a circular arc towards +x, p_angle (radians) from root to tip.
	void bend(float p_angle) {
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			Eigen::Vector3f place = rest(b, 1);
			for (int k = 1; k < GRASS_SEGMENTS; k++) {
				const float angle = p_angle * float(k) / float(GRASS_SEGMENTS - 1);
				place += (rest(b, k + 1) - rest(b, k)).norm() * Eigen::Vector3f(sin_of(angle), cos_of(angle), 0.0f);
				set_knot(b, k + 1, place);
			}
		}
	}

	GrassCollider &add(int p_shape, const Eigen::Vector3f &p_place, const Eigen::Vector3f &p_size) {
		GrassCollider collider;
		collider.anchor.z = p_shape;
		collider.rotation = collider.rotation_before = { 0.0f, 0.0f, 0.0f, 1.0f };
		collider.size = { p_size.x(), p_size.y(), p_size.z(), 0.0f };
		if (p_shape == GRASS_HULL) { // a box of that size, given by its planes
			planes = { { 1, 0, 0, p_size.x() }, { -1, 0, 0, p_size.x() }, { 0, 1, 0, p_size.y() }, { 0, -1, 0, p_size.y() },
				{ 0, 0, 1, p_size.z() }, { 0, 0, -1, p_size.z() } };
			collider.size.x = p_size.norm();
			collider.position_before.w = float(planes.size());
		}
		colliders.push_back(collider);
		place(colliders.back(), p_place, p_place);
		return colliders.back();
	}
	static void place(GrassCollider &r_collider, const Eigen::Vector3f &p_before, const Eigen::Vector3f &p_now) {
		r_collider.position = { p_now.x(), p_now.y(), p_now.z(), 0.5f };
		r_collider.position_before = { p_before.x(), p_before.y(), p_before.z(), r_collider.position_before.w };
	}
	std::vector<TileCollider> tile_colliders() const {
		std::vector<TileCollider> made;
		for (const GrassCollider &collider : colliders) {
			TileCollider one;
			if (make_tile_collider(collider, 0, 0, 0.5f, planes, one)) {
				made.push_back(one);
			}
		}
		return made;
	}

	void step(double p_delta = 1.0 / 60.0) {
		const GrassStep step = clock.advance(params, p_delta);
		energy = step_function(*tile, { &step, 1 }, blend, tile_colliders());
	}
	void step_for(double p_seconds, double p_rate = 60.0) {
		for (int i = 0; i < int(std::lround(p_seconds * p_rate)); i++) {
			step(1.0 / p_rate);
		}
	}

	// Returns the largest of something over all knots that move.
	float largest(const std::function<float(int, int)> &p_measure) const {
		float most = 0.0f;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				const float value = p_measure(b, k);
				most = value <= most || std::isnan(most) ? most : value; // keeps NaN
			}
		}
		return most;
	}
	// Error of a segment's length, as a share of it.
	float stretch() const {
		return largest([&](int b, int k) {
			const float wanted = (rest(b, k) - rest(b, k - 1)).norm();
			return std::abs((knot(b, k) - knot(b, k - 1)).norm() - wanted) / wanted;
		});
	}
	// Returns how far any knot is from its rest place, blade lengths.
	float distance_from_rest() const {
		return largest([&](int b, int k) { return (knot(b, k) - rest(b, k)).norm() / length; });
	}
	// Returns how far any knot of another scene with the same blades is from this one's, blade lengths.
	float distance_from(const BladeScene &p_other) const {
		return largest([&](int b, int k) { return (knot(b, k) - p_other.knot(b, k)).norm() / length; });
	}
	bool is_exactly_at_rest() const {
		return std::memcmp(&tile->rest[0][GRASS_CLAMPED_KNOTS], tile->knots[0], sizeof(tile->knots[0])) == 0 &&
				std::memcmp(&tile->rest[1][GRASS_CLAMPED_KNOTS], tile->knots[1], sizeof(tile->knots[1])) == 0 &&
				std::memcmp(&tile->rest[2][GRASS_CLAMPED_KNOTS], tile->knots[2], sizeof(tile->knots[2])) == 0;
	}
	bool is_finite() const {
		return std::isfinite(largest([&](int b, int k) { return knot(b, k).cwiseAbs().sum(); }));
	}
	// Returns how deep a knot is in a collider, metres.
	float depth_in(const TileCollider &p_collider, int p_blade, int p_knot) const {
		return depth_of(p_collider, offset_from(p_collider, p_blade, knot(p_blade, p_knot)));
	}
	// Returns how deep a point of a segment, p_share along it, is in a collider, metres.
	float depth_in(const TileCollider &p_collider, int p_blade, int p_segment, float p_share) const {
		const Eigen::Vector3f along = knot(p_blade, p_segment + 1) - knot(p_blade, p_segment);
		return depth_of(p_collider, offset_from(p_collider, p_blade, knot(p_blade, p_segment) + along * p_share));
	}
	// Returns how deep a point of an edge is in a collider, metres: of the blades whose clamped segment is outside of all.
	float edge_depth() const {
		constexpr int POINTS = 16; // of an edge
		float deepest = 0.0f;
		for (const TileCollider &collider : tile_colliders()) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				float clamp = 0.0f;
				edge_depth_of(collider, b, 0, POINTS, clamp);
				for (int s = 1; s < GRASS_SEGMENTS && !(clamp > 0.0f); s++) {
					edge_depth_of(collider, b, s, POINTS, deepest);
				}
			}
		}
		return deepest;
	}
	// Returns how deep a knot is in a collider, metres: of the blades whose clamp no collider covers, since a covered blade
	// has nowhere to go.
	float depth() const {
		const std::vector<TileCollider> all = tile_colliders();
		float deepest = 0.0f;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const bool is_covered =
					std::any_of(all.begin(), all.end(), [&](const TileCollider &p_one) { return depth_in(p_one, b, 1) > 0.0f; });
			for (const TileCollider &collider : all) {
				for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS && !is_covered; k++) {
					deepen(collider, offset_from(collider, b, knot(b, k)), deepest);
				}
			}
		}
		return deepest;
	}

private:
	Vec3<float> offset_from(const TileCollider &p_collider, int p_blade, const Eigen::Vector3f &p_place) const {
		const Vec3<float> root{ tile->root[0][p_blade], tile->root[1][p_blade], tile->root[2][p_blade] };
		return Vec3<float>{ p_place.x(), p_place.y(), p_place.z() } + (root - p_collider.centre);
	}
	static float depth_of(const TileCollider &p_collider, const Vec3<float> &p_offset) {
		return -find_face(p_collider, turned(inverse_of(p_collider.turn), p_offset)).distance;
	}
	// Raises r_deepest to the depth of a point. Not by the collider's own bound, which is under test: a generous one.
	static void deepen(const TileCollider &p_collider, const Vec3<float> &p_offset, float &r_deepest) {
		const float reach = p_collider.size.x + p_collider.size.y + p_collider.size.z;
		if (!(dot(p_offset, p_offset) > reach * reach)) {
			r_deepest = std::max(r_deepest, depth_of(p_collider, p_offset));
		}
	}
	// The same for p_points + 1 points of a segment.
	void edge_depth_of(const TileCollider &p_collider, int p_blade, int p_segment, int p_points, float &r_deepest) const {
		const Vec3<float> from = offset_from(p_collider, p_blade, knot(p_blade, p_segment));
		const Vec3<float> along = offset_from(p_collider, p_blade, knot(p_blade, p_segment + 1)) - from;
		for (int i = 0; i <= p_points; i++) {
			deepen(p_collider, from + along * (float(i) / float(p_points)), r_deepest);
		}
	}
};

} // namespace grass::test
