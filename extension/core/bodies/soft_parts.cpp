// SPDX-License-Identifier: MIT
#include "core/bodies/soft_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace grass {

namespace {

using SoftFace = std::array<int, 3>;

// A part with fewer faces is not divided.
constexpr size_t FACES_MIN = 8;

// Merges points at the same place: a mesh has a point twice where its normals or UVs differ.
std::vector<int> weld(std::span<const Eigen::Vector3d> p_points) {
	std::map<std::array<double, 3>, int> first;
	std::vector<int> welded;
	for (const Eigen::Vector3d &point : p_points) {
		welded.push_back(first.emplace(std::array<double, 3>{ point.x(), point.y(), point.z() }, int(welded.size())).first->second);
	}
	return welded;
}

std::vector<SoftFace> find_faces(std::span<const int> p_faces, const std::vector<int> &p_welded) {
	std::vector<SoftFace> faces;
	for (size_t i = 0; i + 2 < p_faces.size(); i += 3) {
		SoftFace face{};
		bool is_sound = true;
		for (size_t k = 0; k < 3; k++) {
			const int point = p_faces[i + k];
			is_sound = is_sound && point >= 0 && size_t(point) < p_welded.size();
			face[k] = is_sound ? p_welded[size_t(point)] : 0;
		}
		if (is_sound && face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) {
			faces.push_back(face);
		}
	}
	return faces;
}

// Returns whether every edge is shared by two faces.
bool is_closed(const std::vector<SoftFace> &p_faces) {
	std::map<std::pair<int, int>, int> edges;
	for (const SoftFace &face : p_faces) {
		for (size_t k = 0; k < 3; k++) {
			const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
			edges[{ low, high }]++;
		}
	}
	return !edges.empty() && std::all_of(edges.begin(), edges.end(), [](const auto &p_edge) { return p_edge.second == 2; });
}

// Divides the faces into halves across the longest side, recursively.
void divide(std::vector<SoftFace> p_faces, std::span<const Eigen::Vector3d> p_points, int p_parts,
		std::vector<std::vector<SoftFace>> &r_parts) {
	if (p_parts < 2 || p_faces.size() < FACES_MIN) {
		r_parts.push_back(std::move(p_faces));
		return;
	}
	const auto middle = [&](const SoftFace &p_face) -> Eigen::Vector3d {
		return p_points[size_t(p_face[0])] + p_points[size_t(p_face[1])] + p_points[size_t(p_face[2])];
	};
	Eigen::AlignedBox3d box;
	for (const SoftFace &face : p_faces) {
		box.extend(middle(face));
	}
	int axis = 0;
	box.sizes().maxCoeff(&axis);
	std::stable_sort(p_faces.begin(), p_faces.end(),
			[&](const SoftFace &p_a, const SoftFace &p_b) { return middle(p_a)[axis] < middle(p_b)[axis]; });
	const auto half = p_faces.begin() + std::ptrdiff_t(p_faces.size() / 2);
	divide({ p_faces.begin(), half }, p_points, p_parts / 2, r_parts);
	divide({ half, p_faces.end() }, p_points, p_parts / 2, r_parts);
}

// Returns the points of the faces, thinned out where there are too many.
std::vector<int> find_points(const std::vector<SoftFace> &p_faces) {
	std::vector<int> points;
	for (const SoftFace &face : p_faces) {
		points.insert(points.end(), face.begin(), face.end());
	}
	std::sort(points.begin(), points.end());
	points.erase(std::unique(points.begin(), points.end()), points.end());
	const size_t stride = (points.size() + SoftParts::MAX_POINTS - 1) / SoftParts::MAX_POINTS;
	std::vector<int> kept;
	for (size_t i = 0; i < points.size(); i += stride) {
		kept.push_back(points[i]);
	}
	return kept;
}

} // namespace

SoftParts::SoftParts(std::span<const Eigen::Vector3d> p_points, std::span<const int> p_faces) {
	std::vector<SoftFace> faces = find_faces(p_faces, weld(p_points));
	std::erase_if(faces, [&](const SoftFace &p_face) {
		return !std::all_of(p_face.begin(), p_face.end(), [&](int p_point) { return p_points[size_t(p_point)].allFinite(); });
	});
	if (faces.empty()) {
		return;
	}
	_is_closed = is_closed(faces);
	std::vector<std::vector<SoftFace>> divided;
	divide(std::move(faces), p_points, MAX_PARTS, divided);
	for (const std::vector<SoftFace> &part : divided) {
		_parts.push_back(find_points(part));
		_points.insert(_points.end(), _parts.back().begin(), _parts.back().end());
	}
	std::sort(_points.begin(), _points.end());
	_points.erase(std::unique(_points.begin(), _points.end()), _points.end());
	for (std::vector<int> &part : _parts) {
		for (int &point : part) {
			point = int(std::lower_bound(_points.begin(), _points.end(), point) - _points.begin());
		}
	}
}

void SoftParts::bound(std::span<const Eigen::Vector3d> p_places, std::vector<Hull> &r_hulls) const {
	r_hulls.assign(_parts.size(), Hull());
	if (p_places.size() != _points.size()) {
		return;
	}
	Eigen::Vector3d middle = Eigen::Vector3d::Zero();
	for (const Eigen::Vector3d &place : p_places) {
		middle += place / double(p_places.size());
	}
	std::vector<Eigen::Vector3d> places;
	for (size_t i = 0; i < _parts.size(); i++) {
		places.clear();
		bool is_sound = middle.allFinite();
		for (const int point : _parts[i]) {
			places.push_back(p_places[size_t(point)]);
			is_sound = is_sound && places.back().cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= Hull::MAX_COORDINATE;
		}
		if (_is_closed) {
			places.push_back(middle); // a part extends from the surface to the middle
		}
		if (is_sound) {
			r_hulls[i] = Hull::make_bound(places, MARGIN);
		}
	}
}

} // namespace grass
