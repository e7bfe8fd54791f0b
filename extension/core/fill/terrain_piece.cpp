// SPDX-License-Identifier: MIT
#include "core/fill/terrain_piece.h"

#include "core/fill/fill.h"

#include <algorithm>

namespace grass {

namespace {

constexpr double TEXEL = info_of(MAP_GROUND).texel_size();

double distance_to_region(const MapRegion &p_region, const Eigen::Vector2d &p_place) {
	return (p_place - p_place.cwiseMax(p_region.min).cwiseMin(p_region.max)).squaredNorm();
}

} // namespace

TerrainPiece::TerrainPiece(const MapRegion &p_region, const GroundGrid &p_grid) : _region(p_region), _grid(p_grid) {
	const Eigen::Array2d offset = p_grid.offset();
	const Eigen::Array2i first = ((p_region.min.array() - offset) / TEXEL - 0.5).ceil().cast<int>(),
						 last = ((p_region.max.array() - offset) / TEXEL - 0.5).ceil().cast<int>() - 1;
	_first = first - 1;
	const bool is_empty = (last < first).any();
	_size = is_empty ? Eigen::Array2i(0, 0) : Eigen::Array2i(last - first + 3);
}

std::vector<Eigen::Vector2d> TerrainPiece::get_next(size_t p_most) const {
	std::vector<Eigen::Vector2d> next;
	const int width = std::max(_size.x(), 1), read = int(_samples.size()), j = _first.y() + read / width;
	for (int i = read % width; i < _size.x() && next.size() < p_most; i++) {
		next.push_back(Eigen::Vector2d((_first.x() + i + 0.5) * TEXEL, (j + 0.5) * TEXEL) + _grid.offset());
	}
	return next;
}

void TerrainPiece::put_next(std::span<const TerrainSample> p_samples) {
	_samples.insert(_samples.end(), p_samples.begin(), p_samples.end());
}

const TerrainSample &TerrainPiece::at(const Eigen::Vector2d &p_place) const {
	const Eigen::Array2i texel = ((p_place - _grid.offset()).array() / TEXEL).floor().cast<int>() - _first;
	return _samples[size_t(texel.y()) * size_t(_size.x()) + size_t(texel.x())];
}

LaidGround TerrainPiece::lay(PaintMap &r_map, double p_ledge_slope) const {
	return lay_ground(
			r_map, _region, [this](const Eigen::Vector2d &p_place) { return at(p_place).height; }, MissingGround::HOLE,
			[this](const Eigen::Vector2d &p_place) { return at(p_place).normal; }, { nullptr, p_ledge_slope });
}

bool TerrainPiece::put_textures(TerrainIds &r_ids) const {
	bool differs = false;
	r_ids.set_grid(_grid);
	for (int j = 1; j < _size.y() - 1; j++) {
		for (int i = 1; i < _size.x() - 1; i++) {
			const TerrainTexel &texture = _samples[size_t(j) * size_t(_size.x()) + size_t(i)].texture;
			differs = r_ids.set(_first.x() + i, _first.y() + j, texture) || differs;
		}
	}
	return differs;
}

void TerrainPiece::put_colors(TerrainColors &r_colors) const {
	for (int j = 1; j < _size.y() - 1; j++) {
		for (int i = 1; i < _size.x() - 1; i++) {
			const Eigen::Vector2d place((_first.x() + i + 0.5) * TEXEL, (_first.y() + j + 0.5) * TEXEL);
			r_colors.set(place, _samples[size_t(j) * size_t(_size.x()) + size_t(i)].color);
		}
	}
}

void TerrainQueue::set_area(const MapRegion &p_area) {
	_area = p_area;
	_waiting.clear();
}

void TerrainQueue::add(const MapRegion &p_region) {
	const MapRegion region = p_region.shared(_area);
	if (!region.min.allFinite() || !region.max.allFinite() || (region.min.array() > region.max.array()).any()) {
		return;
	}
	for (const MapKey &key : chunks_in(region)) {
		const MapRegion part = region.shared(MapRegion::of_chunk(key));
		const auto [entry, is_new] = _waiting.try_emplace(key, part);
		if (!is_new) {
			entry->second = entry->second.joined(part);
		}
	}
}

std::optional<MapRegion> TerrainQueue::take(std::span<const Eigen::Vector2d> p_eyes) {
	const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
	const std::span<const Eigen::Vector2d> eyes = p_eyes.empty() ? std::span(&origin, 1) : p_eyes;
	double least = std::numeric_limits<double>::infinity();
	auto nearest = _waiting.end();
	for (auto entry = _waiting.begin(); entry != _waiting.end(); ++entry) {
		for (const Eigen::Vector2d &eye : eyes) {
			const double distance = distance_to_region(entry->second, eye);
			if (distance < least) {
				least = distance;
				nearest = entry;
			}
		}
	}
	if (nearest == _waiting.end()) {
		return {};
	}
	const MapRegion region = nearest->second;
	_waiting.erase(nearest);
	return region;
}

} // namespace grass
