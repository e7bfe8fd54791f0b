// SPDX-License-Identifier: MIT
#include "core/field/field.h"

#include "core/base/cpu_clock.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Grass this far outside the view counts as visible, so that it is up to date when a camera turns towards it. Metres. Smaller: bodies
// visibly push into the grass when the camera turns fast. Larger: more invisible grass is simulated.
constexpr float VIEW_MARGIN = 3.0f;
// Blades move by their strains once a swing has died down to a tenth since a collider was in their tile, at the latest after this, seconds.
constexpr double MOST_ALONE_TIME = 2.0;

} // namespace

Field::Field(std::shared_ptr<PoolBudget> p_budget) : _pool_budget(std::move(p_budget)) {
	if (_pool_budget) {
		_pool_budget->join(*this);
	}
}

Field::~Field() {
	if (_pool_budget) {
		_pool_budget->leave(*this);
	}
}

void Field::set(const FieldSetup &p_setup, const std::shared_ptr<TileBounds> &p_bounds, const MapLayers *p_map,
		const SpeciesPatches &p_species, const FieldParams &p_params) {
	_setup = p_setup;
	_bounds = p_bounds;
	_map = p_map;
	_species = p_species;
	set_params(p_params);
	_regrown = {};
	_changed_tiles = all_tiles();
	_bounds->set_cover(p_map != nullptr ? p_map->get_cover() : nullptr,
			p_map != nullptr ? slope_lean(_setup.follow_slope) * _setup.blade_length() : 0.0);
	_blades = FieldBlades(_setup.grid, _setup.patch, _setup.clump, _setup.seed, _setup.species, p_map);
	_tiles.set_grid(_setup.grid);
	_tiles.set_params(tile_params());
	_tiles.set_bounds(_bounds);
	_tiles.get_detail().forget();
	rest();
	_clock.reset();
	_budget.reset();
	_untimed_steps = 0;
}

void Field::forget_map() {
	_map = nullptr;
	_blades = FieldBlades();
}

void Field::set_params(const FieldParams &p_params) {
	_params = p_params;
	_params.solver.method = _setup.method;
	std::ranges::for_each(_params.species, [this](SolverParams &r_species) { r_species.method = _setup.method; });
}

void Field::rest() {
	_tiles.reset();
	_room = 0;
	if (_pool_budget) { // a field that has left the tree has no ticks
		_pool_budget->report(*this, 0, false);
	}
}

void Field::set_pool_size(Simulator &r_simulator, int p_slots) {
	const std::vector<SlotMove> moves = _tiles.resize_pool(p_slots);
	_setup.pool_size = _tiles.get_params().pool_size;
	fit_pool(r_simulator, moves);
}

void Field::fit_pool(Simulator &r_simulator, std::span<const SlotMove> p_moves) {
	if (_room != _tiles.get_room() || !p_moves.empty()) {
		_room = _tiles.get_room();
		r_simulator.resize_pool(_room, p_moves);
	}
}

// Prepares the slots of the next tick. Where all blades are simulated, they come at once: a replay must get the same slots in the same
// step.
void Field::prepare_pool(Simulator &r_simulator) {
	const int wanted = _tiles.get_room_plan().get_wanted(), most = TileParams::MAX_POOL_SIZE;
	const bool is_whole = _params.detail == SimulationDetail::WHOLE, is_ready = r_simulator.prepare_pool(wanted);
	_tiles.get_room_plan().set_ready(is_whole ? most : r_simulator.get_slots_at_once(), is_ready ? wanted : 0);
}

TileParams Field::tile_params() const {
	TileParams params;
	params.pool_size = _setup.pool_size;
	params.contact_distance = _params.solver.contact_rate > CONTACT_RATE.minimum ? _params.contact_distance : 0.0;
	params.sleep_mode = _params.sleep_mode;
	params.sleep_delay = _params.sleep_delay;
	params.sleep_energy = _params.calm_energy();
	params.still_delay = _params.calm_time();
	params.alone_time = std::min(0.5 * _params.calm_time(), MOST_ALONE_TIME); // calm is a hundredth
	params.alone_air = _params.alone_air(double(_setup.patch ? _setup.blade_length() : 0.0f));
	params.settle_time = _params.settle_time;
	params.overhang = _bounds ? _bounds->get_overhang() : 0.0;
	params.low = _bounds ? _bounds->get_low() : 0.0;
	params.height = _bounds ? _bounds->get_height() : 0.0;
	params.segment = _setup.patch ? double(_setup.blade_length()) * GRASS_SEGMENT_SHARE : 0.0;
	params.is_mapped = _blades.needs_growth();
	params.seed = _setup.seed;
	return params;
}

void Field::stir() {
	_tiles.set_params(tile_params());
	_tiles.stir(all_tiles());
}

void Field::regrow(const TileRange &p_tiles) {
	_tiles.get_detail().forget();
	_regrown = _regrown.count() > 0 ? _regrown.joined(p_tiles) : p_tiles;
	_changed_tiles = _changed_tiles.count() > 0 ? _changed_tiles.joined(p_tiles) : p_tiles;
	_tiles.set_params(tile_params()); // they depend on the lowest and highest ground
}

void Field::see(Simulator &r_simulator, const FieldView &p_view, bool p_is_visible) {
	see_tiles(p_view, p_is_visible);
	if (see_detail(r_simulator, p_view)) {
		widen(r_simulator);
	}
}

// Plants draw other blades of their tiles than the first ones.
bool Field::see_detail(Simulator &r_simulator, const FieldView &p_view) {
	TileDetail &detail = _tiles.get_detail();
	const bool is_thinned = _params.detail == SimulationDetail::SEEN && p_view.is_drawn && !_setup.has_plants && r_simulator.can_join();
	const bool is_other = detail.set_coarseness(_budget.get_coarseness());
	const bool is_seen_otherwise =
			is_thinned ? detail.see(_setup.cull_field(), p_view, _map != nullptr ? _map->get_cover() : nullptr) : detail.see_all();
	return is_other || is_seen_otherwise;
}

void Field::widen(Simulator &r_simulator) {
	const std::span<const GrassSlot> slots = _tiles.widen();
	if (!slots.empty()) {
		r_simulator.join(slots, _step);
	}
}

void Field::ask(Simulator &r_simulator, std::span<const int> p_tiles) {
	bool is_new = false;
	for (const int tile : p_tiles) {
		is_new = _tiles.get_detail().ask(tile) || is_new;
	}
	if (is_new) {
		widen(r_simulator);
	}
}

void Field::see_tiles(const FieldView &p_view, bool p_is_visible) {
	if (p_view.cameras.empty() && !p_view.is_watched && p_is_visible) {
		_tiles.get_view().see_all();
		_is_seen = true;
		return;
	}
	std::vector<Frustum> frustums;
	std::vector<Eigen::Vector3f> eyes;
	for (const ViewCamera &camera : p_view.cameras) {
		frustums.push_back(camera.planes);
		eyes.push_back(camera.eye);
	}
	float margin = std::max(VIEW_MARGIN, p_view.shadow_margin);
	for (const Eigen::Vector3f &fall : p_view.falls) {
		margin = std::max(margin, fall.norm());
	}
	_tiles.get_view().see(frustums, margin, eyes);
	_is_seen = _tiles.is_field_seen();
}

bool Field::begin_tick(Simulator &r_simulator, bool p_is_listened, double p_delta) {
	prepare_pool(r_simulator);
	if (holds_slots()) {
		fit_pool(r_simulator, _tiles.trim(p_delta));
	}
	if (_pool_budget) {
		fit_pool(r_simulator, _tiles.grant(_pool_budget->grant(*this, _tiles.get_statistics().awake)));
	}
	_can_simulate = r_simulator.can_simulate();
	if ((_is_seen && _can_simulate) || p_is_listened) {
		return true;
	}
	_unseen_time += p_delta;
	_unseen_ticks += _can_simulate ? 1 : 0;
	return false;
}

bool Field::resume() {
	const bool has_passed = _unseen_time > 0.0;
	if (has_passed) {
		_tiles.pass_unseen(_unseen_time);
	}
	_unseen_time = 0.0;
	return has_passed;
}

bool Field::tick(Simulator &r_simulator, std::span<ColliderShape> p_colliders, double p_delta, std::span<const Force> p_forces,
		const ParallelFor &p_parallel_for) {
	CpuClock clock;
	_tiles.report_energy(r_simulator.read_energy());
	_tiles.stir(r_simulator.is_complete() ? _regrown : all_tiles());
	_tiles.update(p_delta, p_colliders, p_parallel_for);
	_tiles_ms = clock.lap();
	if (!_can_simulate) {
		_tiles.reset(); // which bodies meet grass is known; the blades stay at rest
		return false;
	}
	fit_pool(r_simulator);
	if (_pool_budget) {
		_pool_budget->report(*this, _tiles.get_statistics().awake, _tiles.lacks_grant());
	}
	const bool has_moved = !_tiles.get_slots().empty(); // else nothing is awake: no dispatch, no upload
	if (has_moved) {
		step(r_simulator, p_delta, p_forces);
		spend_budget(r_simulator);
	}
	prepare_pool(r_simulator); // for the next tick; last, since a driver that makes memory on a thread lets this one make none
	return has_moved;
}

// Compares the time of the last step with the budget. The next frame applies the result.
void Field::spend_budget(Simulator &r_simulator) {
	const StepTime time = r_simulator.read_step_time();
	const bool is_new = time.count != _times_read;
	_times_read = time.count;
	_untimed_steps = has_budget() && time.count == 0 ? std::min(_untimed_steps + 1, MOST_UNTIMED) : 0;
	_budget.advance(has_budget() ? _params.budget : 0.0, is_new ? time.ms : 0.0);
}

void Field::step(Simulator &r_simulator, double p_delta, std::span<const Force> p_forces) {
	_forces.clear();
	for (const Force &force : p_forces) {
		_forces.push_back(force.pack(_setup.grid));
	}
	StepInput input;
	input.number = _tiles.get_step_number();
	input.slots = _tiles.get_slots();
	input.colliders = _tiles.get_colliders();
	input.followers = _tiles.get_followers();
	input.sharp = _tiles.get_sharp();
	input.collider_list = _tiles.get_collider_list();
	input.planes = _tiles.get_planes();
	input.forces = _forces;
	input.growth = grow_tiles();
	input.step = _clock.advance(_params.solver, p_delta);
	_species_steps.clear();
	for (const SolverParams &species : _params.species) {
		_species_steps.push_back(_clock.repeat(species));
	}
	input.species = _species_steps;
	input.step.field = { float(_setup.grid.get_tile_size()), float(_setup.grid.get_tiles_x()), float(_setup.grid.get_tiles_z()),
		float(GRASS_KNOTS) };
	input.step.clump = { _setup.clump.size, _setup.clump.height, _setup.clump.lean, _setup.clump.tint };
	_step = input.step;
	r_simulator.step(input);
}

// Returns the growth of the blades of tiles that woke in this tick, and of awake tiles on which the map changed.
std::span<const SlotGrowth> Field::grow_tiles() {
	_growth.clear();
	if (_blades.needs_growth()) {
		for (const GrassSlot &slot : _tiles.get_slots()) {
			const bool is_retired = slot.list.w & GRASS_SLOT_RETIRED, is_fresh = slot.list.w & GRASS_SLOT_FRESH;
			if (!is_retired && (is_fresh || _regrown.has(slot.tile.x, slot.tile.y))) {
				_growth.push_back(_blades.grow(slot));
			}
		}
		_regrown = {};
	}
	return _growth;
}

double Field::ground_relief() const {
	return _map != nullptr ? std::max(-get_cover()->get_low(), get_cover()->get_high()) : 0.0;
}

double Field::ground_range() const {
	return _map != nullptr ? double(get_cover()->get_high()) - double(get_cover()->get_low()) : 0.0;
}

std::shared_ptr<TileBounds> Field::bounds_of(const FieldSetup &p_next) const {
	ClumpParams clump = _setup.clump;
	clump.origin = p_next.clump.origin; // bounds are valid anywhere in the noise
	const bool same_blades = _bounds && _setup.patch == p_next.patch && clump == p_next.clump && _setup.seed == p_next.seed &&
			_setup.is_mapped == p_next.is_mapped && (_setup.species == nullptr) == (p_next.species == nullptr) &&
			_setup.card_size == p_next.card_size && _setup.follow_slope == p_next.follow_slope;
	return same_blades ? std::make_shared<TileBounds>(*_bounds, p_next.grid)
					   : std::make_shared<TileBounds>(*p_next.patch, p_next.grid, p_next.clump, p_next.seed);
}

// Returns a root in field space, metres, at the field's height.
Eigen::Vector3d Field::root_of(const Eigen::Vector2f &p_root, int p_x, int p_z) const {
	const Eigen::Vector2d offset = (p_root.cast<double>().array() - 0.5) * _setup.grid.get_tile_size();
	return _setup.grid.get_centre(p_x, p_z) + Eigen::Vector3d(offset.x(), 0.0, offset.y());
}

KnotsOf<double> Field::find_knots(BladeNumber p_blade, const SimulatedKnots &p_simulated) const {
	const int x = _setup.grid.get_x(tile_of(p_blade)), z = _setup.grid.get_z(tile_of(p_blade));
	const FieldBlades::Pose pose = _blades.get_pose(x, z, blade_in_tile(p_blade));
	const Eigen::Vector3d root = get_root(pose, x, z);
	KnotsOf<double> knots;
	for (int knot = 0; knot < GRASS_KNOTS; knot++) {
		const bool is_at_rest = !p_simulated || knot < GRASS_CLAMPED_KNOTS;
		const Eigen::Vector3f in_blade = is_at_rest ? _blades.get_rest_knot(pose, knot) : (*p_simulated)[size_t(knot)];
		knots[size_t(knot)] = root + in_blade.cast<double>();
	}
	return knots;
}

TileRange Field::tiles_around(const Eigen::Vector2d &p_place, double p_radius) const {
	return _setup.grid.get_range(p_place.x() - p_radius, p_place.x() + p_radius, p_place.y() - p_radius, p_place.y() + p_radius, 0.0);
}

std::vector<BladeNumber> Field::find_blades(const Eigen::Vector2d &p_place, double p_radius) const {
	std::vector<BladeNumber> found;
	const TileRange tiles = tiles_around(p_place, p_radius);
	for (int z = tiles.z_begin; z < tiles.z_end; z++) {
		for (int x = tiles.x_begin; x < tiles.x_end; x++) {
			for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
				// The stems of a plant share its root.
				const Eigen::Vector2f place = _setup.has_plants ? _blades.get_pose(x, z, blade).root : _blades.get_root(x, z, blade);
				const Eigen::Vector3d root = root_of(place, x, z);
				if (std::hypot(root.x() - p_place.x(), root.z() - p_place.y()) <= p_radius && _blades.stands(x, z, blade)) {
					found.push_back(number_of(_setup.grid.get_index(x, z), blade));
				}
			}
		}
	}
	return found;
}

} // namespace grass
