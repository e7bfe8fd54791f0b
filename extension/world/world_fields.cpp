// SPDX-License-Identifier: MIT
#include "world/world_fields.h"

#include "shared/script_call.h"

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr real_t AWAY = -1e5f; // metres: below everything, so that no body meets a waiting field

} // namespace

GrassField *field_with(uint64_t p_id) {
	return p_id != 0 ? Object::cast_to<GrassField>(ObjectDB::get_instance(p_id)) : nullptr;
}

GrassField *WorldFields::make() {
	const Ref<PackedScene> scene = _scene;
	Node *made = nullptr;
	const bool lives = outlives(_world, [&] { made = scene.is_valid() && scene->can_instantiate() ? scene->instantiate() : nullptr; });
	if (!lives) {
		if (made != nullptr) {
			memdelete(made);
		}
		return nullptr;
	}
	GrassField *field = Object::cast_to<GrassField>(made);
	_has_wrong_scene = _scene.is_valid() && field == nullptr;
	if (field == nullptr) {
		if (made != nullptr) {
			memdelete(made);
		}
		field = memnew(GrassField);
	}
	field->get_parts().settings.set_size(Vector2(real_t(_side), real_t(_side)));
	field->get_parts().settings.set_param(PARAM_BORDER_FADE, 0.0);
	field->set_visible(false);
	field->set_streamed();
	field->get_report().set_warning_teller(make_teller());
	return field;
}

// Returns what the fields report their warnings to. A problem of one plot is usually one of all plots, so the world reports it once.
FieldReport::WarningTeller WorldFields::make_teller() const {
	return [warned_of = _warned_of, label = _label](const String &p_warning) {
		if (warned_of->insert(p_warning.utf8().get_data()).second) {
			WARN_PRINT(vformat("%s: `plot_scene`: %s", label, p_warning));
		}
	};
}

void WorldFields::start(const Ref<PackedScene> &p_scene, double p_side, const String &p_label) {
	if (_scene != p_scene) {
		_warned_of = std::make_shared<std::set<std::string>>();
	}
	_scene = p_scene;
	_side = p_side;
	_label = p_label;
	_made = 0;
	_firsts = 0;
	_place.reset();
	const GrassField *first = make_first();
	if (first == nullptr) {
		return;
	}
	_pattern = {};
	_pattern.has_terrain = !first->get_parts().sources.get_terrain().is_empty();
	_pattern.pool_tiles = first->get_parts().settings.get_pool_tiles();
	_pattern.collision_mask = uint32_t(first->get_parts().settings.get_collision_mask());
	_pattern.layers = first->get_layer_mask();
	_pattern.tile_size = first->get_parts().queries.get_tile_size();
	_pattern.map.set_base_density(1.0);
	if (first->get_map().is_valid()) {
		_pattern.map = first->get_map()->get_map();
	}
}

GrassField *WorldFields::make_first() {
	forget_first();
	GrassField *first = make();
	if (first == nullptr) {
		return nullptr;
	}
	forget_first(); // a script of the scene may have restarted the world
	_first = first->get_instance_id();
	_firsts++;
	return first;
}

void WorldFields::forget_first() {
	if (GrassField *first = field_with(_first)) {
		memdelete(first);
	}
	_first = 0;
}

void WorldFields::find_place() {
	if (_place || _first == 0) {
		return;
	}
	const GrassField *first = field_with(_first);
	if (first == nullptr && _firsts == MOST_FIRST) {
		_first = 0;
		WARN_PRINT(
				vformat("%s: `plot_scene`: a script frees the fields of the scene as soon as they are made, so there is no grass. Remove "
						"the call of free() or queue_free().",
						_label));
		return;
	}
	if (first == nullptr && (first = make_first()) == nullptr) {
		return;
	}
	_place = first->find_map_place();
	if (_place) {
		forget_first();
	}
}

void WorldFields::stop() {
	forget_first();
	while (!_spare.empty()) {
		free_spare();
	}
}

void WorldFields::forget_lost() {
	std::erase_if(_spare, [](uint64_t p_id) {
		const GrassField *field = field_with(p_id);
		return field == nullptr || !field->is_inside_tree();
	});
}

GrassField *WorldFields::take() {
	forget_lost();
	if (!_spare.empty()) {
		GrassField *field = field_with(_spare.back());
		_spare.pop_back();
		return field;
	}
	GrassField *field = make();
	if (field == nullptr) {
		return nullptr;
	}
	for (int32_t i = _world.get_child_count(); i < _world.get_child_count(true); i++) { // after the user's own children
		if (const GrassField *other = Object::cast_to<GrassField>(_world.get_child(i, true))) {
			field->join(*other);
			break;
		}
	}
	const uint64_t id = field->get_instance_id();
	if (!outlives(_world, [&] { _world.add_child(field, false, Node::INTERNAL_MODE_BACK); })) {
		return nullptr;
	}
	_made++;
	field = field_with(id);
	return field != nullptr && field->is_inside_tree() ? field : nullptr;
}

void WorldFields::give_back(GrassField *p_field, bool p_keeps) {
	if (!p_field->is_inside_tree()) {
		return;
	}
	if (p_keeps && _spare.size() < MOST_SPARE) {
		_spare.push_back(p_field->get_instance_id());
		p_field->set_position(Vector3(0, AWAY, 0));
		p_field->set_visible(false); // last, since a script may be notified
	} else {
		p_field->queue_free();
	}
}

void WorldFields::free_spare() {
	if (GrassField *field = field_with(_spare.back())) {
		field->queue_free();
	}
	_spare.pop_back();
}

} // namespace grass
