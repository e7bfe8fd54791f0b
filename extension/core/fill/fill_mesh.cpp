// SPDX-License-Identifier: MIT
#include "core/fill/fill_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr const MapChannelInfo &DENSITY_TEXELS = info_of(MAP_DENSITY);

// A triangle seen from above; gives the barycentric weights of a place.
struct Flat {
	Eigen::Vector2d corner, edge_b, edge_c;
	double area;

	explicit Flat(const std::array<FillMesh::Corner, 3> &p_triangle) {
		const auto flat = [](const Eigen::Vector3d &p_at) { return Eigen::Vector2d(p_at.x(), p_at.z()); };
		corner = flat(p_triangle[0].at);
		edge_b = flat(p_triangle[1].at) - corner;
		edge_c = flat(p_triangle[2].at) - corner;
		area = edge_b.x() * edge_c.y() - edge_b.y() * edge_c.x();
	}
	Eigen::Array3d weights(const Eigen::Vector2d &p_at) const {
		const Eigen::Vector2d out = p_at - corner;
		const double b = (out.x() * edge_c.y() - out.y() * edge_c.x()) / area, c = (edge_b.x() * out.y() - edge_b.y() * out.x()) / area;
		return { 1.0 - b - c, b, c };
	}
};

Eigen::Array2d least(const std::array<FillMesh::Corner, 3> &p_triangle) {
	const auto &[a, b, c] = p_triangle;
	return { std::min({ a.at.x(), b.at.x(), c.at.x() }), std::min({ a.at.z(), b.at.z(), c.at.z() }) };
}

Eigen::Array2d greatest(const std::array<FillMesh::Corner, 3> &p_triangle) {
	const auto &[a, b, c] = p_triangle;
	return { std::max({ a.at.x(), b.at.x(), c.at.x() }), std::max({ a.at.z(), b.at.z(), c.at.z() }) };
}

} // namespace

void FillMesh::add(const Corner &p_a, const Corner &p_b, const Corner &p_c) {
	const Triangle triangle = { p_a, p_b, p_c };
	for (const Corner &corner : triangle) {
		if (!(corner.at.array().abs() <= MAX_POSITION).all() || !std::isfinite(corner.share)) {
			return;
		}
	}
	if (!(std::abs(Flat(triangle).area) > 1e-12)) {
		return; // a vertical triangle
	}
	constexpr double REACH = PaintMap::REACH;
	const Eigen::Array2i first = (least(triangle) / MAP_CHUNK_SIZE).floor().max(-REACH).min(REACH).cast<int>(),
						 last = (greatest(triangle) / MAP_CHUNK_SIZE).floor().max(-REACH - 1.0).min(REACH - 1.0).cast<int>();
	for (int z = first.y(); z <= last.y(); z++) {
		for (int x = first.x(); x <= last.x(); x++) {
			_by_chunk[{ x, z }].push_back(_triangles.size());
		}
	}
	_triangles.push_back(triangle);
}

std::vector<double> FillMesh::get_shares(const MapKey &p_key) const {
	const size_t count = size_t(DENSITY_TEXELS.side) * size_t(DENSITY_TEXELS.side);
	std::vector<double> shares(count, 0.0), heights(count, -std::numeric_limits<double>::infinity());
	const auto found = _by_chunk.find(p_key);
	if (found == _by_chunk.end()) {
		return shares;
	}
	const Eigen::Array2d origin(p_key.x * MAP_CHUNK_SIZE, p_key.z * MAP_CHUNK_SIZE);
	const double size = DENSITY_TEXELS.texel_size();
	for (const size_t index : found->second) {
		const Triangle &triangle = _triangles[index];
		const Flat flat(triangle);
		const Eigen::Array2i first = ((least(triangle) - origin) / size - 0.5).ceil().max(0.0).cast<int>(),
							 last = ((greatest(triangle) - origin) / size - 0.5).floor().min(DENSITY_TEXELS.side - 1.0).cast<int>();
		for (int j = first.y(); j <= last.y(); j++) {
			for (int i = first.x(); i <= last.x(); i++) {
				const Eigen::Array3d weights = flat.weights((origin + size * (Eigen::Array2d(i, j) + 0.5)).matrix());
				const size_t texel = size_t(j) * size_t(DENSITY_TEXELS.side) + size_t(i);
				const double height = weights[0] * triangle[0].at.y() + weights[1] * triangle[1].at.y() + weights[2] * triangle[2].at.y();
				if ((weights >= -1e-9).all() && height > heights[texel]) {
					heights[texel] = height;
					shares[texel] = weights[0] * triangle[0].share + weights[1] * triangle[1].share + weights[2] * triangle[2].share;
				}
			}
		}
	}
	return shares;
}

} // namespace grass
