// SPDX-License-Identifier: MIT
#include "field/field_species.h"

#include "field/hung_patches.h"
#include "shared/property_value.h"
#include "shared/script_call.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// A plant is a blade from where on it is nine pixels high, in a picture of 1,080 lines and 75 degrees: so many times its height away. More:
// plants that look the same as blades are chosen one by one.
constexpr double IMPOSTOR_REACH = 80.0;
// A mesh that is drawn up to here is not missed: from there on its impostor has more texels than pixels. Metres.
constexpr double NEAR_ENOUGH = 4.0;

} // namespace

// Returns the joined patch, which all fields of these species share: it takes megabytes, and milliseconds. Main thread only.
std::shared_ptr<const Patch> FieldSpecies::find_join(const Joining &p_joining) {
	static std::vector<std::pair<Joining, std::weak_ptr<const Patch>>> made;
	std::erase_if(made, [](const auto &p_made) { return p_made.second.expired(); });
	for (const auto &[joining, patch] : made) {
		if (joining == p_joining) {
			return patch.lock();
		}
	}
	auto patch = std::make_shared<const Patch>(join_patches(p_joining.from, p_joining.shares, p_joining.stems, p_joining.tussocks));
	made.emplace_back(p_joining, patch);
	return patch;
}

std::vector<SolverParams> solvers_of(const std::vector<GrownSpecies> &p_species, const SolverParams &p_field) {
	std::vector<SolverParams> solvers;
	for (const GrownSpecies &grown : p_species) {
		solvers.push_back(grown.species->get_solver(p_field));
	}
	return solvers;
}

std::vector<std::shared_ptr<const Patch>> patches_of(const std::vector<GrownSpecies> &p_species) {
	std::vector<std::shared_ptr<const Patch>> patches;
	for (const GrownSpecies &grown : p_species) {
		patches.push_back(grown.patch);
	}
	return patches;
}

void FieldSpecies::set(const TypedArray<GrassSpecies> &p_species, const Callable &p_changed) {
	for (const Ref<GrassSpecies> &species : _list) {
		if (species.is_valid() && species->is_connected("changed", p_changed)) { // one may be there twice
			species->disconnect("changed", p_changed);
		}
	}
	List list;
	for (int64_t i = 0; i < p_species.size(); i++) {
		const Ref<GrassSpecies> species = p_species[i];
		if (species.is_valid() && !species->is_connected("changed", p_changed)) {
			species->connect("changed", p_changed);
		}
		list.push_back(species);
	}
	(void)replace(_list, list);
}

TypedArray<GrassSpecies> FieldSpecies::get() const {
	TypedArray<GrassSpecies> species;
	for (const Ref<GrassSpecies> &one : value_of(_list)) {
		species.push_back(one);
	}
	return species;
}

bool FieldSpecies::is_plain() const {
	return _list.empty() || (_list.size() == 1 && (_list[0].is_null() || _list[0]->is_plain()));
}

bool FieldSpecies::prepare_patches() const {
	bool are_made = !_list.empty() || GrassPatch::is_default_made();
	for (const Ref<GrassSpecies> &species : _list) {
		are_made = (species.is_null() ? GrassPatch::is_default_made() : species->prepare_patch()) && are_made;
	}
	if (!are_made || is_upright()) {
		return are_made;
	}
	for (const Ref<GrassSpecies> &species : find_used()) { // all of them: each begins its thread
		are_made = prepare_hung(species->find_patch(), species->get_solver(SolverParams()), _pull, species->get_stems()) && are_made;
	}
	return are_made;
}

std::shared_ptr<const Patch> FieldSpecies::find_patch(const GrassSpecies &p_species) const {
	const std::shared_ptr<const Patch> patch = p_species.find_patch();
	return is_upright() ? patch : find_hung(patch, p_species.get_solver(SolverParams()), _pull, p_species.get_stems());
}

bool FieldSpecies::read_plants(const Object &p_field) const {
	const List list = _list;
	return std::ranges::all_of(list,
			[&](const Ref<GrassSpecies> &p_species) { return p_species.is_null() || outlives(p_field, [&] { p_species->find_plant(); }); });
}

FieldSpecies::List FieldSpecies::find_used() const {
	List used(_list.begin(), _list.begin() + std::min<size_t>(_list.size(), GRASS_MAX_SPECIES));
	for (Ref<GrassSpecies> &species : used) {
		if (species.is_null()) {
			species.instantiate();
			species->set_param(SPECIES_PARAM_SHARE, 0.0);
		}
	}
	if (used.empty()) {
		used.emplace_back().instantiate();
	}
	return used;
}

std::vector<GrownSpecies> FieldSpecies::find_grown() const {
	std::vector<GrownSpecies> grown;
	for (const Ref<GrassSpecies> &species : find_used()) {
		grown.push_back({ species, find_patch(**species) });
	}
	return grown;
}

std::vector<SpeciesParams> FieldSpecies::find_mix() const {
	std::vector<SpeciesParams> mix;
	for (const Ref<GrassSpecies> &species : find_used()) {
		mix.push_back(species->get_mix());
	}
	return mix;
}

// Returns the shares of all blades, together 1.
std::vector<double> FieldSpecies::find_shares() const {
	std::vector<double> shares;
	double total = 0.0;
	for (const SpeciesParams &mix : find_mix()) {
		shares.push_back(mix.share);
		total += mix.share;
	}
	for (size_t s = 0; s < shares.size(); s++) {
		shares[s] = total > 0.0 ? shares[s] / total : (s == 0 ? 1.0 : 0.0);
	}
	return shares;
}

FieldSpecies::Joining FieldSpecies::find_joining() const {
	Joining joining{ patches_of(find_grown()), find_shares(), find_stems(), {} };
	for (const Ref<GrassSpecies> &species : find_used()) {
		joining.tussocks.push_back(species->get_tussocks());
	}
	return joining;
}

bool FieldSpecies::is_joined() const {
	return _joined && _joined_of == find_joining();
}

std::shared_ptr<const Patch> FieldSpecies::join() const {
	if (Joining now = find_joining(); !_joined || _joined_of != now) {
		const bool is_one = now.from.size() == 1 && now.stems[0] == 1 && now.tussocks[0].share == 0.0;
		_joined = is_one ? now.from[0] : find_join(now);
		_joined_of = std::move(now);
	}
	return _joined;
}

std::vector<int> FieldSpecies::find_stems() const {
	std::vector<int> stems;
	for (const Ref<GrassSpecies> &species : find_used()) {
		stems.push_back(species->get_stems());
	}
	return stems;
}

bool FieldSpecies::has_plant_meshes() const {
	return std::ranges::any_of(
			_list, [](const Ref<GrassSpecies> &p_species) { return p_species.is_valid() && p_species->get_plant_mesh().is_valid(); });
}

bool FieldSpecies::has_plant_scenes() const {
	return std::ranges::any_of(
			_list, [](const Ref<GrassSpecies> &p_species) { return p_species.is_valid() && p_species->get_plant_scene().is_valid(); });
}

std::vector<DrawnPlant> FieldSpecies::find_plants(double p_density) const {
	std::vector<DrawnPlant> plants;
	const std::vector<double> shares = find_shares();
	for (const Ref<GrassSpecies> &species : find_used()) {
		const double density = p_density * shares[plants.size()];
		DrawnPlant &plant = plants.emplace_back();
		plant.model = species->find_plant();
		plant.distance = float(near_plants(species->get_plant_distance(), density, plant.model ? plant.model->vertices : 0));
		if (const std::shared_ptr<const Patch> patch = plant.model ? find_patch(**species) : nullptr) {
			plant.length = patch->mean_length;
			plant.max_length = patch->max_length * CLUMP_TALLEST;
			plant.blade_area = patch->mean_width * patch->mean_length;
			plant.stems = species->get_stems();
			plant.impostor = species->find_impostor();
			const double pictured = std::max(double(plant.distance), IMPOSTOR_REACH * double(plant.length));
			plant.impostor_distance = std::max(plant.distance, float(near_plants(pictured, density, PlantImpostor::VERTICES)));
		}
	}
	return plants;
}

float FieldSpecies::find_card_size() const {
	double most = 0.0;
	for (const Ref<GrassSpecies> &species : find_used()) {
		most = std::max(most, species->get_card_size());
	}
	return float(most);
}

float FieldSpecies::find_leaf_area() const {
	const std::vector<double> shares = find_shares();
	double area = 0.0;
	size_t s = 0;
	for (const Ref<GrassSpecies> &species : find_used()) {
		area += shares[s++] * species->get_leaf_area();
	}
	return float(area);
}

void FieldSpecies::warn_of_plants(int64_t p_species, double p_density, PackedStringArray &r_warnings) const {
	const Ref<GrassSpecies> &species = _list[size_t(p_species)];
	const int64_t vertices = species->find_plant()->vertices;
	const double distance = species->get_plant_distance(), near = near_plants(distance, p_density, vertices);
	if (near < std::min(distance, NEAR_ENOUGH)) { // beyond it they look alike
		r_warnings.push_back(
				vformat("`plant_mesh` of species %d is drawn up to %.1f m, not up to its `plant_distance`: it has %d vertices, and %.1f "
						"plants grow per square metre. Lower `density`, the species' `share`, or its vertices.",
						p_species, near, vertices, p_density));
	}
}

void FieldSpecies::warn(PackedStringArray &r_warnings, double p_density) const {
	if (_list.size() > GRASS_MAX_SPECIES) {
		r_warnings.push_back(
				vformat("`species` has more than %d entries, and the rest do not grow. Use a second field for them.", GRASS_MAX_SPECIES));
	}
	for (size_t i = 0; i < std::min<size_t>(_list.size(), GRASS_MAX_SPECIES); i++) {
		if (_list[i].is_null()) {
			r_warnings.push_back(
					vformat("`species` has an empty entry %d, which grows only where it is painted. Fill it or remove it.", int64_t(i)));
		} else if (_list[i]->prepare_patch() && _list[i]->find_patch()->is_empty()) {
			r_warnings.push_back(vformat("Species %d has no blades: %s", int64_t(i), _list[i]->find_patch()->empty_because));
		}
		if (_list[i].is_valid() && !_list[i]->get_plant_problem().is_empty()) {
			r_warnings.push_back(
					vformat("`plant_mesh` of species %d is not drawn: %s It grows as blades.", int64_t(i), _list[i]->get_plant_problem()));
		}
		if (_list[i].is_valid() && _list[i]->get_plant_scene().is_valid() && !_list[i]->get_plant_scene()->can_instantiate()) {
			r_warnings.push_back(
					vformat("`plant_scene` of species %d holds no nodes, so its plants have none. Save a scene with a Node3D as "
							"its root, and choose it here.",
							int64_t(i)));
		}
		if (_list[i].is_valid() && _list[i]->find_plant()) {
			warn_of_plants(int64_t(i), p_density * find_shares()[i], r_warnings);
		}
		if (_list[i].is_valid() && _list[i]->get_patch().is_valid()) {
			r_warnings.append_array(_list[i]->get_patch()->find_warnings(vformat("The patch of species %d", int64_t(i))));
		}
	}
}

} // namespace grass
