// SPDX-License-Identifier: MIT
#include "field/field_maker.h"

#include "draw/field_shaders.h"
#include "draw/frame_share.h"
#include "draw/patch_texture.h"
#include "gpu/device.h"
#include "gpu/obstacles.h"

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

void FieldMaker::request() {
	_is_waiting = true;
	_most_ms = 0.0;
	_is_stale = _wanted.has_value();
}

void FieldMaker::drop() {
	_wanted.reset();
	_is_stale = false;
}

bool FieldMaker::prepare(const FieldProperties &p_properties, const Field &p_now, Backend *p_backend) {
	const bool in_parts = p_backend != nullptr || p_properties.is_streamed;
	if (_is_stale && (p_backend == nullptr || p_properties.is_streamed)) { // nobody sees it
		drop();
	}
	const bool has_patches = !in_parts || p_properties.species.prepare_patches();
	if (!_wanted && !has_patches) {
		return false;
	}
	FrameShare::Turn turn(this);
	const auto has_time = [&] { return !in_parts || (p_properties.is_streamed ? turn.has_part() : turn.has_time()); };
	if (!_wanted && has_time()) {
		_wanted = find_wanted(p_properties);
	}
	if (_wanted && !_wanted->bounds && has_time()) {
		_wanted->bounds = p_now.bounds_of(_wanted->setup);
	}
	if (!_wanted || !_wanted->bounds) {
		return false;
	}
	const bool has_ledges = _wanted->painted.is_valid() && _wanted->painted->get_map().uses(MAP_LEDGE);
	const Look look{ shader_features(_wanted->setup) | (has_ledges ? SHADER_LEDGES : 0), p_properties.hook.get_text() };
	const bool has_shaders = !in_parts || ((p_backend == nullptr || p_backend->prepare(_wanted->setup)) & prepare_shaders(look));
	return has_shaders && prepare_map(has_time) && has_time();
}

bool FieldMaker::prepare_map(const std::function<bool()> &p_has_time) {
	if (!_wanted->setup.is_mapped || _wanted->setup.patch->is_empty()) {
		return true;
	}
	std::unique_ptr<ShownMap> &map = _wanted->map;
	if (!map && p_has_time()) {
		map = std::make_unique<ShownMap>(_wanted->painted, _wanted->setup, _is_stale ? nullptr : std::move(_prepared));
	}
	while (map && map->has_work()) {
		if (map->is_waiting_for_thread() || !p_has_time()) {
			return false;
		}
		map->work();
	}
	return map != nullptr;
}

std::optional<ShownPlace> FieldMaker::find_place(const FieldProperties &p_properties) {
	if (!p_properties.species.prepare_patches()) {
		return {};
	}
	return shown_place_of(find_wanted(p_properties).setup);
}

WantedField FieldMaker::find_wanted(const FieldProperties &p_properties) {
	WantedField wanted;
	FieldSetup &setup = wanted.setup;
	setup.grid = p_properties.grid();
	setup.patch = p_properties.species.join();
	setup.clump = p_properties.clump();
	setup.pool_size = int(p_properties.pool_tiles);
	setup.method = p_properties.method;
	setup.drawn_tiles_max = int(p_properties.param(PARAM_DRAWN_TILES_MAX));
	setup.seed = uint32_t(p_properties.seed);
	wanted.painted = p_properties.map;
	setup.is_mapped = wanted.painted.is_valid();
	setup.follow_slope = float(p_properties.param(PARAM_FOLLOW_SLOPE));
	setup.has_terrain = p_properties.find_terrain_texture().is_valid();
	setup.card_size = p_properties.species.find_card_size();
	setup.leaf_area = p_properties.species.find_leaf_area();
	wanted.plants = p_properties.species.find_plants(p_properties.param(PARAM_DENSITY));
	for (const DrawnPlant &plant : wanted.plants) {
		setup.plant_size = std::max(setup.plant_size, plant.size());
	}
	const std::vector<int> stems = p_properties.species.find_stems();
	setup.has_plants = setup.plant_size > 0.0f || std::ranges::any_of(stems, [](int p_stems) { return p_stems > 1; });
	wanted.mix = p_properties.species.find_mix();
	setup.species = p_properties.species.is_plain() ? nullptr
													: std::make_shared<const SpeciesMix>(wanted.mix, setup.grid, setup.seed,
															  Eigen::Vector2d(p_properties.noise_origin.x, p_properties.noise_origin.y));
	wanted.species = p_properties.species.find_grown();
	if (!p_properties.is_on_cpu && main_device() != nullptr) {
		const DeviceFit fit = fit_device(device_limits(), setup);
		setup.pool_size = fit.pool_size;
		setup.drawn_tiles_max = fit.drawn_tiles_max;
	}
	return wanted;
}

WantedField FieldMaker::take() {
	WantedField wanted = std::move(*_wanted);
	_is_waiting = _is_stale;
	drop();
	_makings++;
	return wanted;
}

void FieldMaker::add_time(double p_ms) {
	_most_ms = std::max(_most_ms, p_ms);
}

void FieldMaker::add_to(FieldStatistics &r_statistics) const {
	if (const ShownMap *map = get_map()) {
		r_statistics.map_waiting += map->get_waiting();
	}
	r_statistics.is_waiting = r_statistics.is_waiting || _is_waiting;
	r_statistics.makings = _makings;
	r_statistics.build_ms = _most_ms;
}

} // namespace grass
