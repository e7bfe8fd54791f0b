// SPDX-License-Identifier: MIT
#include "field/plant_nodes.h"

#include "shared/convert.h"
#include "shared/plant_group.h"
#include "shared/script_call.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// In a tick. More: eyes that jump find all nodes sooner, and such a tick takes longer.
constexpr int SHOWN_A_TICK = 4, HIDDEN_A_TICK = 16;

Node3D *node_with(uint64_t p_id) {
	return p_id == 0 ? nullptr : Object::cast_to<Node3D>(ObjectDB::get_instance(p_id));
}

// Returns a node, or null if the game has put it elsewhere meanwhile: then it belongs to the game.
Node3D *unowned_with(uint64_t p_id) {
	Node3D *node = node_with(p_id);
	return node != nullptr && node->get_parent() == nullptr ? node : nullptr;
}

// Returns the transform of a plant: as its mesh is drawn, but upright.
Transform3D transform_of(const StandingScene &p_plant, float p_scale) {
	const real_t x = std::cos(p_plant.angle) * p_scale, z = std::sin(p_plant.angle) * p_scale;
	return Transform3D(Basis(Vector3(x, 0, z), Vector3(0, p_scale, 0), Vector3(-z, 0, x)), to_godot(p_plant.root));
}

} // namespace

PlantNodes::~PlantNodes() {
	for (const auto &[scene, id] : _stored) {
		if (Node3D *node = unowned_with(id)) {
			memdelete(node);
		}
	}
	free_strayed_holder();
}

PlantNodes::Scenes PlantNodes::find_scenes(const StandingField &p_standing) const {
	Scenes scenes;
	const std::vector<GrownSpecies> &grown = p_standing.get_species();
	for (size_t s = 0; s < std::min<size_t>(grown.size(), GRASS_MAX_SPECIES); s++) {
		const Scene scene = grown[s].species->get_plant_scene();
		if (scene.is_valid() && std::ranges::find(_failed, scene) == _failed.end()) {
			scenes[s] = scene;
		}
	}
	return scenes;
}

bool PlantNodes::is_used(const StandingField &p_standing) const {
	return !_shown.empty() || !_stored.empty() || !_failed.empty() ||
			std::ranges::any_of(
					p_standing.get_species(), [](const GrownSpecies &p_grown) { return p_grown.species->get_plant_scene().is_valid(); });
}

std::span<const StandingScene> PlantNodes::choose(
		StandingField &r_standing, const FieldProperties &p_properties, const BodyTracker &p_tracker, const Scenes &p_scenes) {
	PlantSearch::Params params;
	params.border = { float(p_properties.param(PARAM_BORDER_FADE)), float(p_properties.param(PARAM_BORDER_WAVER)) };
	params.most = _host.node().is_visible_in_tree() && follow_scale() ? int(p_properties.param(PARAM_PLANT_NODES_MAX)) : 0;
	bool has_any = false;
	for (size_t s = 0; s < p_scenes.size(); s++) {
		if (p_scenes[s].is_valid()) {
			params.distance[s] = float(r_standing.get_species()[s].species->get_plant_scene_distance());
			has_any = true;
		}
	}
	_search.forget(r_standing.take_changed_tiles());
	if (!has_any || params.most == 0) {
		_search.clear();
		return {};
	}
	std::vector<StandingScene> held;
	for (const auto &[blade, shown] : _shown) {
		held.push_back(shown.plant);
	}
	return _search.choose(r_standing.get_field(), _eyes.find(_host.node(), _host.field_transform(), p_tracker), params, held);
}

bool PlantNodes::update(StandingField &r_standing, const FieldProperties &p_properties, const BodyTracker &p_tracker) {
	const Scenes scenes = find_scenes(r_standing);
	const std::span<const StandingScene> found = choose(r_standing, p_properties, p_tracker, scenes);
	const std::vector<StandingScene> chosen(found.begin(), found.end()); // scripts may change all else
	std::array<float, GRASS_MAX_SPECIES> heights{};
	for (size_t s = 0; s < r_standing.get_species().size(); s++) {
		const GrownSpecies &grown = r_standing.get_species()[s];
		heights[s] = scenes[s].is_valid() ? grown.species->find_plant_height(grown.patch->mean_length) : 0.0f;
	}
	const auto scale_of = [&](const StandingScene &p_plant) { return p_plant.length / std::max(heights[size_t(p_plant.species)], 1e-4f); };
	drop_unused(scenes);
	std::vector<StandingScene> staying = chosen;
	std::ranges::sort(staying, {}, &StandingScene::blade);
	std::vector<BladeNumber> leaving;
	for (const auto &[blade, shown] : _shown) {
		const auto same = std::ranges::lower_bound(staying, blade, {}, &StandingScene::blade);
		const bool stays = same != staying.end() && *same == shown.plant && shown.scale == scale_of(*same) &&
				shown.scene == scenes[size_t(shown.plant.species)];
		if (!stays && leaving.size() < HIDDEN_A_TICK) {
			leaving.push_back(blade);
		}
	}
	const uint64_t leaves = _leaves;
	for (const BladeNumber blade : leaving) {
		if (!hide(blade)) {
			return false;
		}
	}
	int shown = 0;
	for (const StandingScene &plant : chosen) {
		const size_t most = size_t(p_properties.param(PARAM_PLANT_NODES_MAX));
		if (_leaves != leaves || shown >= SHOWN_A_TICK || _shown.size() >= most) {
			break;
		}
		const Scene &scene = scenes[size_t(plant.species)];
		if (_shown.contains(plant.blade) || std::ranges::find(_failed, scene) != _failed.end()) {
			continue;
		}
		shown++;
		if (!show(plant, scene, scale_of(plant))) {
			return false;
		}
	}
	return true;
}

// Cancels the node's own scale, so that everything below the holder has the grass's. Returns false if it cannot.
bool PlantNodes::follow_scale() {
	const Transform3D global = _host.node().get_global_transform();
	if (!global.is_finite() || global.basis.determinant() == 0.0) {
		return false;
	}
	Node3D *holder = find_holder();
	const bool is_scaled = global.basis.determinant() < 0.0 || !global.basis.get_scale().is_equal_approx(Vector3(1, 1, 1));
	const Transform3D wanted = is_scaled ? global.affine_inverse() * _host.field_transform() : Transform3D();
	if (holder != nullptr && holder->get_transform() != wanted) {
		holder->set_transform(wanted);
	}
	return true;
}

// Returns null if there is none, or not here any more: replace_by() gives all children of a node to another one.
Node3D *PlantNodes::find_holder() const {
	Node3D *holder = node_with(_holder);
	return holder != nullptr && holder->get_parent() == &_host.node() ? holder : nullptr;
}

// Frees the one that replace_by() has given away, with what it still holds of a field that is freed.
void PlantNodes::free_strayed_holder() {
	Node3D *holder = node_with(_holder);
	if (holder != nullptr && (!_left.empty() || holder->get_child_count() == 0)) {
		holder->queue_free();
	}
}

// Returns null if a script removed it at once. The caller must know whether the field is still there.
Node3D *PlantNodes::need_holder() {
	if (Node3D *holder = find_holder()) {
		return holder;
	}
	Node3D *made = memnew(Node3D);
	const uint64_t id = made->get_instance_id();
	_holder = id;
	made->set_name("Plants");
	made->add_to_group(PLANT_GROUP);
	if (!outlives(_host.node(), [&] { _host.node().add_child(made, false, Node::INTERNAL_MODE_BACK); })) {
		return nullptr;
	}
	follow_scale();
	return find_holder();
}

// Returns false if a script freed the field.
bool PlantNodes::make(const Scene &p_scene, int p_species, Node3D *&r_node) {
	Node *made = nullptr;
	const Scene scene = p_scene;
	const bool is_there = outlives(_host.node(), [&] { made = scene->can_instantiate() ? scene->instantiate() : nullptr; });
	r_node = Object::cast_to<Node3D>(made);
	if (made != nullptr && (!is_there || r_node == nullptr)) {
		memdelete(made);
	}
	if (!is_there) {
		return false;
	}
	if (r_node == nullptr) {
		_failed.push_back(scene);
		const String why = made == nullptr ? "cannot be instantiated" : "has a root that is no Node3D";
		ERR_PRINT(_host.message(vformat("`plant_scene` of species %d (%s) %s. Its plants are drawn, and have no node.", p_species,
				scene->get_path().is_empty() ? String("a scene without a file") : scene->get_path(), why)));
		return true;
	}
	return true;
}

Node3D *PlantNodes::take(const Scene &p_scene) {
	for (size_t i = _stored.size(); i-- > 0;) {
		if (_stored[i].first == p_scene) {
			Node3D *node = unowned_with(_stored[i].second);
			_stored.erase(_stored.begin() + std::ptrdiff_t(i));
			if (node != nullptr) {
				return node;
			}
		}
	}
	return nullptr;
}

bool PlantNodes::show(const StandingScene &p_plant, const Scene &p_scene, float p_scale) {
	const uint64_t field = _host.node().get_instance_id(), leaves = _leaves;
	Node3D *holder = need_holder();
	if (ObjectDB::get_instance(field) == nullptr) {
		return false;
	}
	Node3D *node = take(p_scene);
	if (node == nullptr && !make(p_scene, p_plant.species, node)) {
		return false;
	}
	if (node == nullptr) {
		return true;
	}
	const uint64_t id = node->get_instance_id();
	if (holder == nullptr || _leaves != leaves || !_host.node().is_inside_tree()) {
		_stored.emplace_back(p_scene, id);
		return true;
	}
	node->set_transform(transform_of(p_plant, p_scale)); // outside of the tree, so that nothing moves there
	_shown[p_plant.blade] = { p_plant, p_scene, p_scale, id };
	if (!outlives(_host.node(), [&] { holder->add_child(node); })) {
		return false;
	}
	const auto shown = _shown.find(p_plant.blade);
	node = node_with(id);
	if (shown == _shown.end() || shown->second.node != id || node == nullptr || !node->is_inside_tree()) {
		return true; // a script put it elsewhere
	}
	node->reset_physics_interpolation();
	return outlives(_host.node(), [&] { _host.node().emit_signal("plant_node_appeared", node, p_plant.species, p_plant.blade); });
}

// Takes a plant's node away. The signal comes first, while the node still exists.
bool PlantNodes::hide(BladeNumber p_blade) {
	const auto left = _shown.extract(p_blade);
	Node3D *node = left.empty() ? nullptr : node_with(left.mapped().node);
	if (node == nullptr) {
		return true;
	}
	const Shown &shown = left.mapped();
	return outlives(_host.node(), [&] { _host.node().emit_signal("plant_node_leaving", node, shown.plant.species, p_blade); }) &&
			store(shown, find_holder());
}

// Stores a node for another plant. One that the game has put elsewhere belongs to the game.
bool PlantNodes::store(const Shown &p_shown, Node3D *p_holder) {
	Node3D *node = node_with(p_shown.node), *holder = p_holder;
	if (node == nullptr || holder == nullptr || node->get_parent() != holder) {
		return true;
	}
	if (!outlives(_host.node(), [&] { holder->remove_child(node); })) {
		return false;
	}
	if (node_with(p_shown.node) != nullptr) {
		_stored.emplace_back(p_shown.scene, p_shown.node);
	}
	return true;
}

bool PlantNodes::leave() {
	_leaves++;
	_search.clear();
	const std::map<BladeNumber, Shown> shown = std::exchange(_shown, {});
	for (const auto &[blade, one] : shown) {
		_left.push_back(one);
	}
	for (const auto &[blade, standing] : shown) {
		const Shown &one = standing; // not the binding itself: Clang 14 captures none
		Node3D *node = node_with(one.node);
		if (node != nullptr && !outlives(_host.node(), [&] {
				_host.node().emit_signal("plant_node_leaving", node, one.plant.species, one.plant.blade);
			})) {
			return false;
		}
	}
	return true;
}

bool PlantNodes::put_away() {
	const std::vector<Shown> left = std::exchange(_left, {});
	if (!std::ranges::all_of(left, [this](const Shown &p_shown) { return store(p_shown, node_with(_holder)); })) {
		return false;
	}
	if (find_holder() == nullptr) {
		free_strayed_holder();
	}
	return true;
}

// Frees what waits for a scene that no species has any more.
void PlantNodes::drop_unused(const Scenes &p_scenes) {
	const auto is_unused = [&](const Scene &p_scene) { return std::ranges::find(p_scenes, p_scene) == p_scenes.end(); };
	for (const auto &[scene, id] : _stored) {
		Node3D *node = is_unused(scene) ? unowned_with(id) : nullptr;
		if (node != nullptr) {
			node->queue_free();
		}
	}
	std::erase_if(_stored, [&](const auto &p_stored) { return is_unused(p_stored.first); });
}

void PlantNodes::add_to(FieldStatistics &r_statistics) const {
	r_statistics.plant_nodes = int64_t(_shown.size());
	r_statistics.stems_looked_at = _search.get_stems_looked_at();
	r_statistics.plant_tiles_looked_at = _search.get_tiles_looked_at();
}

} // namespace grass
