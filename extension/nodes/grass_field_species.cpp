// SPDX-License-Identifier: MIT
// GrassField's species: from the list of resources to one patch, one mix, the steps of a tick and the look.
#include "nodes/grass_field.h"

#include "convert.h"
#include "nodes/main_thread.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::set_species(const TypedArray<GrassSpecies> &p_species) {
	GRASS_MAIN_THREAD_ONLY();
	const Callable changed = callable_mp(this, &GrassField::_species_changed);
	for (const Ref<GrassSpecies> &species : _species) {
		if (species.is_valid() && species->is_connected("changed", changed)) { // one may be there twice
			species->disconnect("changed", changed);
		}
	}
	_species.clear();
	for (int64_t i = 0; i < p_species.size(); i++) {
		const Ref<GrassSpecies> species = p_species[i];
		if (species.is_valid() && !species->is_connected("changed", changed)) {
			species->connect("changed", changed);
		}
		_species.push_back(species);
	}
	request_rebuild();
}

TypedArray<GrassSpecies> GrassField::get_species() const {
	TypedArray<GrassSpecies> species;
	for (const Ref<GrassSpecies> &one : _species) {
		species.push_back(one);
	}
	return species;
}

// Colours and frequencies take effect at once; what changes blades makes the field anew.
void GrassField::_species_changed() {
	if (!is_main_thread()) { // a part of the resource changed on another one
		callable_mp(this, &GrassField::_species_changed).call_deferred();
		return;
	}
	if (_backend && !_dirty && prepare_patches() && are_species_joined() && species_mix() == _standing.mix &&
			card_size() == _standing.setup.card_size) {
		set_species_uniforms();
		update_tiles();
	} else {
		request_rebuild();
	}
}

// The species that count. An empty place in the list is a species of its own, so that the numbers of the others hold.
std::vector<Ref<GrassSpecies>> GrassField::used_species() const {
	std::vector<Ref<GrassSpecies>> used(_species.begin(), _species.begin() + std::min<size_t>(_species.size(), GRASS_MAX_SPECIES));
	for (Ref<GrassSpecies> &species : used) {
		if (species.is_null()) {
			species.instantiate();
			species->set_param(SPECIES_PARAM_SHARE, 0.0);
		}
	}
	return used;
}

std::vector<SpeciesParams> GrassField::species_mix() const {
	std::vector<SpeciesParams> mix;
	for (const Ref<GrassSpecies> &species : used_species()) {
		mix.push_back(species->get_mix());
	}
	return mix;
}

// A species without a patch has the one that fields without a patch have.
std::vector<std::shared_ptr<const Patch>> GrassField::species_patches() const {
	std::vector<std::shared_ptr<const Patch>> patches;
	for (const Ref<GrassSpecies> &species : used_species()) {
		patches.push_back(species->find_patch());
	}
	return patches;
}

// Of all blades, together 1.
std::vector<double> GrassField::species_shares() const {
	std::vector<double> shares;
	double total = 0.0;
	for (const SpeciesParams &mix : species_mix()) {
		shares.push_back(mix.share);
		total += mix.share;
	}
	for (size_t s = 0; s < shares.size(); s++) {
		shares[s] = total > 0.0 ? shares[s] / total : (s == 0 ? 1.0 : 0.0);
	}
	return shares;
}

bool GrassField::are_species_joined() const {
	return _joined && _joined_from == species_patches() && _joined_shares == species_shares();
}

// All species' blades as one patch, the same one until they change.
std::shared_ptr<const Patch> GrassField::join_species() const {
	if (!are_species_joined()) {
		_joined_from = species_patches();
		_joined_shares = species_shares();
		_joined = std::make_shared<const Patch>(join_patches(_joined_from, _joined_shares));
	}
	return _joined;
}

// Of the largest flower or seed head, from its tip, metres; a card on a thinned tile is drawn larger.
float GrassField::card_size() const {
	double most = 0.0;
	for (const Ref<GrassSpecies> &species : used_species()) {
		most = std::max(most, species->get_card_size());
	}
	return float(most);
}

// The step as each species takes it.
std::span<const GrassStep> GrassField::species_steps() {
	_species_steps.clear();
	const SolverParams field = solver_params();
	for (const GrownSpecies &grown : _standing.species) {
		_species_steps.push_back(_clock.repeat(grown.species->get_solver(field)));
	}
	return _species_steps;
}

double GrassField::calm_time() const {
	const SolverParams field = solver_params();
	double time = _standing.species.empty() ? field.calm_time() : 0.0;
	for (const GrownSpecies &grown : _standing.species) {
		time = std::max(time, grown.species->get_solver(field).calm_time());
	}
	return time;
}

// Up to here the blades of every species are calm, J/kg.
double GrassField::calm_energy() const {
	const double distance = 1e-3 * param(PARAM_SLEEP_MOTION);
	const SolverParams field = solver_params();
	double energy = _standing.species.empty() ? field.energy_within(distance) : std::numeric_limits<double>::max();
	for (const GrownSpecies &grown : _standing.species) {
		energy = std::min(energy, grown.species->get_solver(field).energy_within(distance));
	}
	return energy;
}

// Of the grass around a place, metres, without clump and map. p_layers: what is painted there, or null.
double GrassField::mean_height_at(const Eigen::Vector2f &p_place, const MapLayers *p_layers) const {
	if (!_standing.setup.species) {
		return _standing.setup.patch->mean_height;
	}
	const std::array<float, GRASS_MAX_SPECIES> shares = _standing.setup.species->get_shares_at(p_place, p_layers);
	double height = 0.0;
	for (size_t s = 0; s < _standing.species.size(); s++) {
		height += double(shares[s] * _standing.species[s].patch->mean_height);
	}
	return height;
}

RecoveryRates GrassField::recovery_rates() const {
	RecoveryRates rates;
	rates.growth = 1e-3 * param(PARAM_REGROWTH) / 60.0;
	rates.wear[0] = param(PARAM_WEAR_RECOVERY) / 60.0;
	for (size_t s = 0; s < _standing.species.size(); s++) {
		rates.wear[s] = _standing.species[s].species->get_wear_recovery() / 60.0;
	}
	return rates;
}

void GrassField::set_species_uniforms() {
	if (!_standing.setup.species) {
		return;
	}
	PackedInt32Array records;
	for (const SpeciesRecord &record : _standing.setup.species->get_records()) {
		for (const int32_t value : { record.cell, record.strength, record.limit, record.salt }) {
			records.push_back(value);
		}
	}
	records.resize(4 * GRASS_MAX_SPECIES);
	_backend->set_uniform("species_count", _standing.setup.species->get_count());
	_backend->set_uniform("species_mix", records);
	_backend->set_uniform("species_texel", _standing.setup.species->get_texel_units());
	constexpr float OVER_MEAN = 1.1f; // as canopy_height is over the patch's
	constexpr float COVERS = 0.705f * float(GRASS_LOD_FACING); // of width times length: mean of width_at(), seen from anywhere
	std::vector<SpeciesLook> looks;
	for (const GrownSpecies &grown : _standing.species) {
		SpeciesLook look = grown.species->get_look();
		const float own = grown.patch->mean_height * OVER_MEAN, mixed = _standing.setup.patch->mean_height * OVER_MEAN;
		const float alone = float(grown.species->get_mix().stand_strength);
		look.blade_area = COVERS * grown.patch->mean_width * grown.patch->mean_length;
		look.canopy_alone = std::max(own, 0.01f);
		look.canopy_among_others = std::max(mixed + (own - mixed) * alone, 0.01f);
		looks.push_back(look);
	}
	if (!are_made_of(_cards, looks)) {
		_cards = make_cards(looks);
	}
	_backend->set_uniform("species_look", make_look_texture(looks, _cards));
	if (_cards.textures.is_valid()) {
		_backend->set_uniform("card_textures", _cards.textures);
	}
}

void GrassField::warn_of_species(PackedStringArray &r_warnings) const {
	if (_species.empty()) {
		return;
	}
	if (_species.size() > GRASS_MAX_SPECIES) {
		r_warnings.push_back(
				vformat("`species` has more than %d entries, the rest does not grow. Use a second field for them.", GRASS_MAX_SPECIES));
	}
	if (_patch.is_valid()) {
		r_warnings.push_back("`patch` is not used while `species` has entries. Give it to one of the species, or empty one of the two.");
	}
	for (size_t i = 0; i < std::min<size_t>(_species.size(), GRASS_MAX_SPECIES); i++) {
		if (_species[i].is_null()) {
			r_warnings.push_back(
					vformat("`species` has an empty entry %d, which grows only where it is painted. Fill it or remove it.", int64_t(i)));
		} else if (_species[i]->prepare_patch() && _species[i]->find_patch()->is_empty()) {
			r_warnings.push_back(vformat("Species %d has no blades: %s", int64_t(i), _species[i]->find_patch()->empty_because));
		}
		if (_species[i].is_valid() && _species[i]->get_patch().is_valid()) {
			r_warnings.append_array(_species[i]->get_patch()->find_warnings(vformat("The patch of species %d", int64_t(i))));
		}
	}
}

int64_t GrassField::get_blade_species(const Vector2i &p_tile, int64_t p_blade) const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!_backend, 0, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(
			!_standing.setup.grid.has_tile(p_tile.x, p_tile.y), 0, message("there is no such tile. get_tiles() tells how many there are."));
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), 0, message("a tile has 64 blades, 0 to 63."));
	return _standing.blades.get_pose(p_tile.x, p_tile.y, int(p_blade)).species;
}

} // namespace grass
