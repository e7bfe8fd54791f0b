// SPDX-License-Identifier: MIT
// Puts the mesh into a coarse grid of cells, finds what it encloses by a flood from outside, and cuts the least convex boxes of cells in
// two where that helps most. A piece is the hull of all faces within its box.
#include "core/bodies/mesh_pieces.h"

#include "core/base/beside.h"
#include "core/bodies/mesh_cells.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace grass {

namespace {

using Points = std::vector<Eigen::Vector3d>;

// Boxes less concave than this are not cut: share of the ways between their cells that lead outside.
constexpr double CONVEX_ENOUGH = 0.04;
// A piece meets the tiles from which blades reach it, too: as if it were so much larger. Metres.
constexpr double REACHED_FROM = 1.5;
// Up to so many times the pairs of tiles and colliders that the box around the mesh has, any cut is made. Beyond, only one that takes away
// this share of all that is hollow: the hole of a ring is worth it. An estimate from above: where it is 3.2, tiles count 2.4 times.
constexpr double MOST_MEETINGS = 3.2, WORTH = 0.25;
constexpr size_t REMEMBERED = 16; // meshes

struct Part {
	CellBox box;
	double hollow; // concavity times the number of cells
	double concavity;
};

Part make_part(const MeshCells &p_cells, const CellBox &p_box) {
	const MeshCells::Shape shape = p_cells.look_at(p_box);
	return { p_box, shape.concavity * double(shape.count), shape.concavity };
}

// Returns the two halves that are least hollow together.
std::pair<Part, Part> cut(const MeshCells &p_cells, const CellBox &p_box) {
	std::pair<Part, Part> best;
	double least = std::numeric_limits<double>::infinity();
	for (int axis = 0; axis < 3; axis++) {
		for (int at = p_box.low[axis] + 1; at < p_box.high[axis]; at++) {
			CellBox low = p_box, high = p_box;
			low.high[axis] = high.low[axis] = at;
			const std::pair halves(make_part(p_cells, low), make_part(p_cells, high));
			const double hollow = halves.first.hollow + halves.second.hollow;
			if (hollow < least) {
				least = hollow;
				best = halves;
			}
		}
	}
	return best;
}

// Pairs of tiles and pieces, as a multiple of those of the box around all of them: the mean over the three directions that may be up.
double count_pairs(const MeshCells &p_cells, std::span<const Part> p_parts) {
	const auto areas = [&](const CellBox &p_box) {
		const Eigen::Array3d sides = (p_cells.corner_of(p_box.high) - p_cells.corner_of(p_box.low)).array() + REACHED_FROM;
		return Eigen::Array3d(sides.y() * sides.z(), sides.z() * sides.x(), sides.x() * sides.y());
	};
	Eigen::Array3d sum = Eigen::Array3d::Zero();
	for (const Part &part : p_parts) {
		sum += areas(part.box);
	}
	return (sum / areas(p_cells.get_box())).mean();
}

double sum_hollows(std::span<const Part> p_parts) {
	double sum = 0.0;
	for (const Part &part : p_parts) {
		sum += part.hollow;
	}
	return sum;
}

std::vector<Part> split(const MeshCells &p_cells) {
	std::vector<Part> parts{ make_part(p_cells, p_cells.get_box()) };
	while (int(parts.size()) < MeshPieces::MAX_PIECES) {
		const auto worst =
				std::max_element(parts.begin(), parts.end(), [](const Part &p_a, const Part &p_b) { return p_a.hollow < p_b.hollow; });
		if (worst->concavity <= CONVEX_ENOUGH || (worst->box.high - worst->box.low).maxCoeff() < 2) {
			break;
		}
		std::vector<Part> finer = parts;
		const auto [low, high] = cut(p_cells, worst->box);
		finer[size_t(worst - parts.begin())] = low;
		finer.push_back(high);
		if (count_pairs(p_cells, finer) > MOST_MEETINGS && sum_hollows(finer) > (1.0 - WORTH) * sum_hollows(parts)) {
			break;
		}
		parts.swap(finer);
	}
	return parts;
}

// Returns the part of a polygon beyond p_at along an axis (p_sign 1: above it, -1: below).
Points clip(const Points &p_polygon, int p_axis, double p_at, double p_sign) {
	Points kept;
	for (size_t i = 0; i < p_polygon.size(); i++) {
		const Eigen::Vector3d &a = p_polygon[i], &b = p_polygon[(i + 1) % p_polygon.size()];
		const double beyond_a = p_sign * (a[p_axis] - p_at), beyond_b = p_sign * (b[p_axis] - p_at);
		if (beyond_a >= 0.0) {
			kept.push_back(a);
		}
		if ((beyond_a > 0.0 && beyond_b < 0.0) || (beyond_a < 0.0 && beyond_b > 0.0)) {
			kept.push_back(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
		}
	}
	return kept;
}

Hull make_hull(const MeshCells &p_cells, const CellBox &p_box, std::span<const Eigen::Vector3d> p_corners) {
	const Eigen::Vector3d low = p_cells.corner_of(p_box.low), high = p_cells.corner_of(p_box.high);
	Points points = p_cells.enclosed_corners(p_box);
	for (size_t i = 0; i + 2 < p_corners.size(); i += 3) {
		Points face(p_corners.begin() + std::ptrdiff_t(i), p_corners.begin() + std::ptrdiff_t(i + 3));
		for (int axis = 0; axis < 3 && !face.empty(); axis++) {
			face = clip(clip(face, axis, low[axis], 1.0), axis, high[axis], -1.0);
		}
		points.insert(points.end(), face.begin(), face.end());
	}
	return Hull::make(points);
}

} // namespace

std::vector<Hull> MeshPieces::make(std::span<const Eigen::Vector3d> p_corners) {
	const bool is_sound = std::all_of(p_corners.begin(), p_corners.end(),
			[](const Eigen::Vector3d &p_corner) { return p_corner.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= Hull::MAX_COORDINATE; });
	std::vector<Hull> hulls;
	if (p_corners.size() < 3 || p_corners.size() > 3 * MAX_FACES || !is_sound) {
		return hulls;
	}
	const MeshCells cells(p_corners);
	for (const Part &part : split(cells)) {
		Hull hull = make_hull(cells, part.box, p_corners);
		if (!hull.planes.empty()) {
			hulls.push_back(std::move(hull));
		}
	}
	return hulls;
}

MeshPieces::Future MeshPieces::begin(Points p_corners) {
	static std::deque<std::pair<Points, Future>> begun;
	const auto found = std::find_if(begun.begin(), begun.end(), [&](const auto &p_one) { return p_one.first == p_corners; });
	if (found != begun.end()) {
		return found->second;
	}
	if (begun.size() == REMEMBERED) {
		begun.pop_front();
	}
	Future future = run_beside([p_corners] { return make(p_corners); }).share();
	begun.emplace_back(std::move(p_corners), future);
	return future;
}

} // namespace grass
