// SPDX-License-Identifier: MIT
#include "core/fill/fill_cause.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace grass {

namespace {

constexpr const MapChannelInfo &CHANNEL = info_of(MAP_DENSITY);

double mesh_share(const FillSources &p_sources, const Eigen::Array2i &p_texel) {
	if (!p_sources.has_mesh || !p_sources.mesh) {
		return p_sources.has_mesh ? 0.0 : 1.0;
	}
	const auto chunk = [](int p_index) { return int(std::floor(double(p_index) / CHANNEL.side)); };
	const MapKey key{ chunk(p_texel.x()), chunk(p_texel.y()) };
	const int column = p_texel.x() - key.x * CHANNEL.side, row = p_texel.y() - key.z * CHANNEL.side;
	return p_sources.mesh->get_shares(key)[size_t(row) * size_t(CHANNEL.side) + size_t(column)];
}

double shown_texture(const FillSources &p_sources, const Eigen::Vector2d &p_at) {
	const TerrainTexel *texel = p_sources.terrain ? p_sources.terrain->find(p_at) : nullptr;
	return texel == nullptr ? -1.0 : double(2 * texel->blend > TerrainTexel::FULL ? texel->overlay : texel->base);
}

} // namespace

FillCause find_fill_cause(const PaintMap &p_map, const FillRule &p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at) {
	const Eigen::Array2i texel = (p_at.array() / CHANNEL.texel_size()).floor().cast<int>();
	const Eigen::Vector2d at = (texel.cast<double>() + 0.5) * CHANNEL.texel_size();
	const FillPlace place{ at, p_map.sample(MAP_GROUND, 0, at) };
	const double tilt = std::min(1.0, std::hypot(p_map.sample(MAP_NORMAL, 0, at), p_map.sample(MAP_NORMAL, 1, at)));
	const double slope = std::asin(tilt) * 180.0 / std::numbers::pi;
	FillCause cause;
	const auto weigh = [&cause](FillCondition p_condition, double p_share, double p_value = 0.0) {
		cause.density *= p_share;
		if (p_share < cause.share) {
			cause.condition = p_condition;
			cause.share = p_share;
			cause.value = p_value;
		}
	};
	weigh(FillCondition::DENSITY, p_rule.get(FILL_DENSITY));
	weigh(FillCondition::MASK, p_rule.mask_share(at));
	weigh(FillCondition::MESH, mesh_share(p_sources, texel));
	weigh(FillCondition::TEXTURE, p_sources.texture_share(p_rule, at), shown_texture(p_sources, at));
	weigh(FillCondition::SLOPE, p_rule.asks_slope() ? p_rule.slope_share(slope) : 1.0, slope);
	weigh(FillCondition::HEIGHT, p_rule.asks_height() ? p_rule.height_share(place.ground) : 1.0, place.ground);
	weigh(FillCondition::NOISE, p_rule.noise_share(at));
	double planted = 0.0;
	for (const std::shared_ptr<const FillObstacle> &obstacle : p_sources.obstacles) {
		planted = std::max(planted, obstacle->is_planting() ? 1.0 - obstacle->get_share(place) : 0.0);
	}
	cause.density = std::max(cause.density, planted);
	cause.share = std::max(cause.share, planted);
	for (const std::shared_ptr<const FillObstacle> &obstacle : p_sources.obstacles) {
		const double share = obstacle->is_planting() ? 1.0 : obstacle->get_share(place);
		cause.density *= share;
		if (share < 1.0 && share <= cause.share) { // name a node rather than a number
			cause.condition = FillCondition::OBSTACLE;
			cause.share = share;
			cause.obstacle = obstacle;
		}
	}
	return cause;
}

} // namespace grass
