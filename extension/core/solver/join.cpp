// SPDX-License-Identifier: MIT
#include "core/solver/join.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>

namespace grass {

namespace {

template <int N> Eigen::Vector3f at(const float (&p_from)[3][N][GRASS_BLADES_PER_TILE], int p_knot, int p_blade) {
	return { p_from[0][p_knot][p_blade], p_from[1][p_knot][p_blade], p_from[2][p_knot][p_blade] };
}

template <int N> void set(const Eigen::Vector3f &p_place, float (&r_to)[3][N][GRASS_BLADES_PER_TILE], int p_knot, int p_blade) {
	for (int c = 0; c < 3; c++) {
		r_to[c][p_knot][p_blade] = p_place[c];
	}
}

int find_nearest(const TileState &p_state, int p_blade, int p_count) {
	int nearest = 0;
	float least = std::numeric_limits<float>::max();
	for (int other = 0; other < p_count; other++) {
		const float x = p_state.root[0][other] - p_state.root[0][p_blade], z = p_state.root[2][other] - p_state.root[2][p_blade];
		const float squared = x * x + z * z;
		if (squared < least) {
			least = squared;
			nearest = other;
		}
	}
	return nearest;
}

void join_blade(TileState &r_state, int p_blade, int p_other, float p_share) {
	const Eigen::Vector3f first = at(r_state.rest, 1, p_blade), other_first = at(r_state.rest, 1, p_other);
	const float ratio = first.norm() / std::max(other_first.norm(), 1e-6f);
	Eigen::Vector3f parent = first, parent_rest = first, parent_offset = Eigen::Vector3f::Zero();
	for (int free = 0; free < GRASS_FREE_KNOTS; free++) {
		const int k = free + GRASS_CLAMPED_KNOTS;
		const Eigen::Vector3f rest = at(r_state.rest, k, p_blade), there = at(r_state.knots, free, p_other);
		const Eigen::Vector3f moved = (there - at(r_state.before, free, p_other)) * ratio;
		Eigen::Vector3f offset = (there - at(r_state.rest, k, p_other)) * ratio, knot = rest;
		float twist = r_state.twist[free][p_other];
		if (p_share < 1.0f) {
			const Eigen::Vector3f alone = at(r_state.knots, free, p_blade) - rest + moved;
			offset = alone + (offset - alone) * p_share;
			twist = r_state.twist[free][p_blade] + (twist - r_state.twist[free][p_blade]) * p_share;
		}
		if (offset.squaredNorm() > 0.0f || parent_offset.squaredNorm() > 0.0f) {
			const Eigen::Vector3f rest_segment = rest - parent_rest, segment = rest_segment + (offset - parent_offset);
			knot = parent + segment * (rest_segment.norm() / std::max(segment.norm(), 1e-6f));
		}
		set(knot, r_state.knots, free, p_blade);
		set(Eigen::Vector3f(knot - moved), r_state.before, free, p_blade);
		r_state.twist[free][p_blade] = twist;
		parent = knot;
		parent_rest = rest;
		parent_offset = offset;
	}
	r_state.calm[p_blade] = r_state.calm[p_other];
	for (int n = 0; n < GRASS_STRAINS; n++) {
		r_state.strains[n][p_blade] = r_state.strains[n][p_other];
		r_state.strains_before[n][p_blade] = r_state.strains_before[n][p_other];
	}
}

} // namespace

void join_blades(TileState &r_state, const Joining &p_joining) {
	for (int blade = std::max(p_joining.begin, p_joining.sources); blade < std::min(p_joining.end, GRASS_BLADES_PER_TILE); blade++) {
		join_blade(r_state, blade, find_nearest(r_state, blade, p_joining.sources), p_joining.share);
	}
}

} // namespace grass
