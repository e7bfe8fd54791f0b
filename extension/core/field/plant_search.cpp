// SPDX-License-Identifier: MIT
#include "core/field/plant_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace grass {

namespace {

// In one call. More: eyes that jump find their plants sooner, and such a tick takes longer.
constexpr int PASSED_MOST = 4096, READS = 48; // tiles passed; tiles whose blades are looked at
// Tiles whose plants are kept. Where eyes reach more, the farthest are not looked at.
constexpr size_t SEARCHED_TILES = 65536;
// An eye that moved less has the same plants near it. Metres.
constexpr double MOTION = 0.25;

// Return of the tiles that are p_ring tiles away along x or z: their number, and where each is.
int count_of(int p_ring) {
	return p_ring == 0 ? 1 : 8 * p_ring;
}
std::pair<int, int> tile_in(int p_ring, int p_step) {
	if (p_ring == 0) {
		return { 0, 0 };
	}
	const int along = p_step % (2 * p_ring) - p_ring;
	switch (p_step / (2 * p_ring)) {
		case 0:
			return { along, -p_ring };
		case 1:
			return { p_ring, along };
		case 2:
			return { -along, p_ring };
		default:
			return { -p_ring, -along };
	}
}

// Returns the distance of a place on the ground from a tile's square.
double from_tile(const TileGrid &p_grid, int p_x, int p_z, const Eigen::Vector3d &p_place) {
	const Eigen::Vector3d off = (p_place - p_grid.get_centre(p_x, p_z)).cwiseAbs();
	const double half = 0.5 * p_grid.get_tile_size();
	return std::hypot(std::max(off.x() - half, 0.0), std::max(off.z() - half, 0.0));
}

// Returns how far above or below all ground a place is.
double above_ground(const Field &p_field, double p_height) {
	const TileCover *cover = p_field.get_cover();
	const double low = cover != nullptr ? double(cover->get_low()) : 0.0, high = cover != nullptr ? double(cover->get_high()) : 0.0;
	return std::max({ low - p_height, p_height - high, 0.0 });
}

} // namespace

void PlantSearch::clear() {
	_known.clear();
	_walks.clear();
	_chosen.clear();
	_is_stale = true;
}

void PlantSearch::forget(const TileRange &p_tiles) {
	if (p_tiles.count() == 0) {
		return;
	}
	const auto is_among = [&](int p_tile) { return p_tiles.has(_grid.get_x(p_tile), _grid.get_z(p_tile)); };
	const auto is_there = [&](const Near &p_near) { return is_among(tile_of(p_near.plant.blade)); };
	std::erase_if(_known, [&](const auto &p_known) { return is_among(p_known.first); });
	for (Walk &walk : _walks) {
		std::erase_if(walk.found, is_there);
		std::erase_if(walk.nearest, is_there);
		walk.is_outdated = true;
	}
	_is_stale = true;
}

bool PlantSearch::is_done() const {
	return std::ranges::all_of(_walks, &Walk::is_done);
}

void PlantSearch::begin(Walk &r_walk, const Field &p_field, const PlantEye &p_eye) const {
	r_walk.eye = p_eye;
	r_walk.tile = _grid.get_place(p_eye.place);
	r_walk.ring = r_walk.step = 0;
	r_walk.found.clear();
	const double farthest = std::min(p_eye.reach, double(std::ranges::max(_params.distance)));
	const double above = above_ground(p_field, p_eye.place.y());
	const double reach = above < farthest ? std::sqrt(farthest * farthest - above * above) : -1.0;
	const double x = p_eye.place.x(), z = p_eye.place.z();
	r_walk.reach = _grid.get_range(x - reach, x + reach, z - reach, z + reach, 0.0).count() > 0 ? reach : -1.0;
	r_walk.is_done = r_walk.is_outdated = false;
}

std::span<const StandingScene> PlantSearch::choose(
		const Field &p_field, std::span<const PlantEye> p_eyes, const Params &p_params, std::span<const StandingScene> p_held) {
	if (!(_params == p_params) || !(_grid == p_field.get_grid())) {
		clear();
		_params = p_params;
		_grid = p_field.get_grid();
	}
	_is_stale = _is_stale || _walks.size() != p_eyes.size();
	_walks.resize(p_eyes.size());
	_steps = PASSED_MOST;
	_reads = READS;
	for (size_t i = 0; i < _walks.size(); i++) {
		Walk &walk = _walks[i];
		const bool has_moved = (walk.eye.place - p_eyes[i].place).norm() > MOTION;
		if ((walk.is_done && (has_moved || walk.is_outdated)) || walk.eye.reach != p_eyes[i].reach) {
			begin(walk, p_field, p_eyes[i]);
			_is_stale = true;
		}
	}
	for (size_t i = 0; i < _walks.size(); i++) {
		const size_t next = (_next + i) % _walks.size();
		if (!_walks[next].is_done) {
			_is_stale = true;
			if (!walk(_walks[next], p_field)) {
				_next = next; // goes on there
				break;
			}
		}
	}
	if (_is_stale) {
		_is_stale = !is_done();
		rank(p_field, p_eyes, p_held);
	}
	return _chosen;
}

// Returns false if it has to go on in the next call.
bool PlantSearch::walk(Walk &r_walk, const Field &p_field) {
	const double tile = _grid.get_tile_size();
	while (r_walk.reach >= 0.0 && (r_walk.ring - 1) * tile <= r_walk.reach) {
		for (; r_walk.step < count_of(r_walk.ring); r_walk.step++) {
			const auto [x, z] = tile_in(r_walk.ring, r_walk.step);
			if (_steps <= 0 || !visit(r_walk, p_field, r_walk.tile.x + x, r_walk.tile.z + z)) {
				return false;
			}
		}
		// All nearer plants are found.
		const double seen = r_walk.ring * tile;
		const auto is_seen = [seen](const Near &p_near) { return p_near.distance <= seen; };
		r_walk.ring++;
		r_walk.step = 0;
		if (int(r_walk.found.size()) >= _params.most && std::ranges::count_if(r_walk.found, is_seen) >= _params.most) {
			break;
		}
	}
	finish(r_walk);
	return true;
}

// Returns false if the tile must be looked at, and no more may be in this call.
bool PlantSearch::visit(Walk &r_walk, const Field &p_field, int p_x, int p_z) {
	_steps--;
	_visits++;
	if (!_grid.has_tile(p_x, p_z) || from_tile(_grid, p_x, p_z, r_walk.eye.place) > r_walk.reach) {
		return true;
	}
	if (const TileCover *cover = p_field.get_cover(); cover != nullptr && cover->get(p_x, p_z).is_bare()) {
		return true;
	}
	const bool may_read = _reads > 0 || _known.contains(_grid.get_index(p_x, p_z));
	const Plants *plants = may_read ? find(p_field, p_x, p_z) : nullptr;
	for (const StandingScene &plant : plants != nullptr ? std::span<const StandingScene>(*plants) : std::span<const StandingScene>()) {
		const double distance = (plant.root - r_walk.eye.place).norm();
		if (distance <= std::min(r_walk.eye.reach, double(_params.distance[size_t(plant.species)]))) {
			r_walk.found.push_back({ distance, plant });
		}
	}
	return may_read;
}

void PlantSearch::finish(Walk &r_walk) const {
	const size_t most = std::min(r_walk.found.size(), size_t(_params.most));
	std::ranges::partial_sort(r_walk.found, r_walk.found.begin() + std::ptrdiff_t(most), {}, &Near::distance);
	r_walk.found.resize(most);
	r_walk.nearest = std::exchange(r_walk.found, {});
	r_walk.is_done = true;
}

// Returns null if too many tiles are known.
const PlantSearch::Plants *PlantSearch::find(const Field &p_field, int p_x, int p_z) {
	const int index = _grid.get_index(p_x, p_z);
	if (const auto known = _known.find(index); known != _known.end()) {
		return &known->second;
	}
	if (_known.size() >= SEARCHED_TILES) {
		drop_far();
		if (_known.size() >= SEARCHED_TILES) {
			return nullptr;
		}
	}
	Plants &plants = _known[index];
	read(p_field, p_x, p_z, plants);
	return &plants;
}

void PlantSearch::drop_far() {
	std::erase_if(_known, [&](const auto &p_known) {
		const int x = _grid.get_x(p_known.first), z = _grid.get_z(p_known.first);
		return std::ranges::none_of(_walks, [&](const Walk &p_walk) { return from_tile(_grid, x, z, p_walk.eye.place) <= p_walk.reach; });
	});
}

void PlantSearch::read(const Field &p_field, int p_x, int p_z, Plants &r_plants) {
	const FieldBlades &blades = p_field.get_blades();
	const SpeciesMix *mix = p_field.get_setup().species.get();
	_reads--;
	_stems += GRASS_BLADES_PER_TILE;
	int next = 0; // blade that may begin another plant
	for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
		const int species = blades.get_species(p_x, p_z, blade);
		const int stems = mix != nullptr ? mix->get_records()[size_t(species)].stems : 1;
		if (blade < next || _params.distance[size_t(species)] <= 0.0f) {
			continue;
		}
		const FieldBlades::Pose pose = blades.get_pose(p_x, p_z, blade);
		const FieldBlades::Standing standing = blades.get_standing(pose, p_x, p_z, blade, _params.border);
		if (!(standing.left >= STANDS)) {
			continue; // maybe another stem does
		}
		next = blade - blade % stems + stems;
		r_plants.push_back({ number_of(_grid.get_index(p_x, p_z), blade), species, p_field.get_root(pose, p_x, p_z), standing.angle,
				standing.length });
	}
}

// Returns how far the plant is from the nearest eye that it matters to, or infinity. p_more: metres that it may be farther away.
double PlantSearch::distance_to(const StandingScene &p_plant, std::span<const PlantEye> p_eyes, double p_more) const {
	double nearest = std::numeric_limits<double>::infinity();
	for (const PlantEye &eye : p_eyes) {
		const double distance = (p_plant.root - eye.place).norm();
		const double limit = std::min(eye.reach, double(_params.distance[size_t(p_plant.species)]));
		nearest = distance <= limit + p_more ? std::min(nearest, distance) : nearest;
	}
	return nearest;
}

// Plants that have a node are compared as if they were nearer, so that none comes and goes where two are equally far away.
void PlantSearch::rank(const Field &p_field, std::span<const PlantEye> p_eyes, std::span<const StandingScene> p_held) {
	std::vector<Near> all;
	for (const StandingScene &held : p_held) {
		const int tile = tile_of(held.blade);
		if (tile >= _grid.get_tile_count()) {
			continue; // of the field before
		}
		const Plants *plants = find(p_field, _grid.get_x(tile), _grid.get_z(tile));
		const double keep = std::max(KEEP_LEAST, KEEP_SHARE * double(_params.distance[size_t(held.species)]));
		const double distance = distance_to(held, p_eyes, keep);
		if (plants != nullptr && std::ranges::find(*plants, held) != plants->end() && std::isfinite(distance)) {
			all.push_back({ distance - keep, held });
		}
	}
	for (const Walk &walk : _walks) {
		for (const std::vector<Near> *some : { &walk.nearest, &walk.found }) {
			for (const Near &near : *some) {
				const double distance = distance_to(near.plant, p_eyes, 0.0);
				if (std::isfinite(distance)) {
					all.push_back({ distance, near.plant });
				}
			}
		}
	}
	// Each once, the held ones first.
	std::ranges::stable_sort(all, {}, [](const Near &p_near) { return p_near.plant.blade; });
	const auto same = [](const Near &p_a, const Near &p_b) { return p_a.plant.blade == p_b.plant.blade; };
	all.erase(std::unique(all.begin(), all.end(), same), all.end());
	std::ranges::stable_sort(all, {}, &Near::distance);
	all.resize(std::min(all.size(), size_t(_params.most)));
	_chosen.clear();
	for (const Near &near : all) {
		_chosen.push_back(near.plant);
	}
}

size_t PlantSearch::get_memory_usage() const {
	size_t bytes = _known.size() * (sizeof(std::pair<int, Plants>) + 2 * sizeof(void *));
	for (const auto &[tile, plants] : _known) {
		bytes += plants.capacity() * sizeof(StandingScene);
	}
	return bytes;
}

} // namespace grass
