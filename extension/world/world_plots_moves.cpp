// SPDX-License-Identifier: MIT
// How plots come and leave, one in a frame, and what becomes of fields that scripts take away.
#include "core/world/plot_map.h"
#include "world/world_plots.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

bool WorldPlots::is_coming() const {
	return std::ranges::any_of(_plots, [](const auto &p_entry) { return p_entry.second.state == State::COMING; });
}

void WorldPlots::tell_once(bool &r_has_told, const PlotKey &p_key, const char *p_text) const {
	if (!std::exchange(r_has_told, true)) {
		WARN_PRINT(vformat("%s: the field of plot (%d, %d) %s", _label, p_key.x, p_key.z, p_text));
	}
}

// Looks after fields that a script may have freed: such a plot is loaded again, unless that would go on for ever. One that is taken before
// its grass is there leaves the plot empty.
void WorldPlots::look_after_fields() {
	std::erase_if(_plots, [](const auto &p_entry) {
		const auto &[key, plot] = p_entry;
		return plot.state == State::STANDING && plot.get_field() == nullptr;
	});
	for (auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		if (plot.state == State::COMING && (field == nullptr || !field->is_inside_tree())) {
			make_empty(key);
		}
	}
}

void WorldPlots::make_empty(const PlotKey &p_key) {
	_plots[p_key] = Plot();
	_plots[p_key].state = State::EMPTY;
	tell_once(_told_of_empty, p_key,
			"was freed or removed from the tree before its grass was shown, by a script of `plot_scene` for instance. The plot stays empty "
			"until it is loaded again. For a plot without grass hide its field, or paint it bare.");
}

// Makes fields as their own frames do: one that does not process makes nothing, and the other plots would wait for it. Returns false if the
// frame ends.
bool WorldPlots::make_fields() {
	std::vector<uint64_t> waiting;
	for (const auto &[key, plot] : _plots) {
		const GrassField *field = plot.get_field();
		if (field != nullptr && field->is_inside_tree() && !field->is_made()) {
			waiting.push_back(plot.field);
		}
	}
	return std::ranges::all_of(waiting, [this](uint64_t p_id) {
		GrassField *field = field_with(p_id);
		return field == nullptr || run([&] { field->come(); });
	});
}

void WorldPlots::show_coming() {
	for (auto &[key, plot] : _plots) {
		GrassField *field = plot.get_field();
		if (plot.state != State::COMING || field == nullptr || !field->is_made()) {
			continue;
		}
		const PlotKey shown = key;
		const uint64_t id = plot.field;
		plot.state = State::STANDING;
		if (run([&] { field->set_visible(true); }) && field_with(id) != nullptr) { // a script may be notified
			_tell("plot_loaded", shown, field);
		}
		return; // a listener may have changed everything
	}
}

// Brings the nearest of the plots that are read.
void WorldPlots::bring_one() {
	if (is_coming()) {
		return;
	}
	for (const PlotKey &key : _memory.get_plan().wanted) {
		const auto found = _plots.find(key);
		if (found != _plots.end() && found->second.state == State::READ) {
			_fields.forget_lost();
			if (_memory.has_room_for(key)) {
				bring(key);
			}
			return;
		}
	}
}

void WorldPlots::bring(PlotKey p_key) {
	GrassField *field = nullptr;
	if (!run([&] { field = _fields.take(); })) {
		return;
	}
	const auto found = _plots.find(p_key);
	if (found == _plots.end() || found->second.state != State::READ) { // a script of the field restarted the world
		if (field != nullptr) {
			field->queue_free();
		}
		return;
	}
	if (field == nullptr) {
		make_empty(p_key);
		return;
	}
	Plot &plot = found->second;
	const Eigen::Vector2d centre = _settings.grid.centre(p_key);
	field->set_position(Vector3(real_t(centre.x()), 0, real_t(centre.y())));
	field->set_noise_origin(Vector2i(int32_t(centre.x()), int32_t(centre.y()))); // whole, since plots consist of whole chunks
	field->get_parts().settings.fit_pool(_memory.find_most_slots());
	Ref<GrassMapSnapshot> snapshot;
	snapshot.instantiate();
	snapshot->map = plot.known;
	Ref<GrassMap> map;
	map.instantiate();
	map->restore_snapshot(snapshot);
	field->show_map(map, std::move(plot.prepared));
	plot.field = field->get_instance_id();
	plot.state = State::COMING;
	_statistics.brought++;
}

// Lets one plot leave. One that was read and is no longer wanted is only forgotten, like one whose field a listener has just freed.
void WorldPlots::leave_one() {
	const std::vector<PlotKey> leaving = _memory.get_plan().leaving; // listeners may restart the world
	const bool is_all_here = std::ranges::all_of(_memory.get_plan().wanted, [this](const PlotKey &p_key) {
		const auto found = _plots.find(p_key);
		return found != _plots.end() && (found->second.state == State::STANDING || found->second.state == State::EMPTY);
	});
	for (const PlotKey &key : leaving) {
		const Plot &plot = _plots.at(key);
		if (plot.get_field() == nullptr) {
			_plots.erase(key);
		} else if (plot.state == State::STANDING &&
				(_fields.count_spare() < WorldFields::MOST_SPARE || is_all_here || _memory.is_exceeded())) {
			leave(key, plot.field);
			return;
		}
	}
	if (_memory.get_plan().leaving.empty() && _fields.count_spare() > 0 && _memory.is_exceeded()) {
		_fields.free_spare();
	}
}

void WorldPlots::leave(PlotKey p_key, uint64_t p_field) {
	if (!run([&] { _tell("plot_leaving", p_key, field_with(p_field)); })) {
		return;
	}
	const auto found = _plots.find(p_key);
	GrassField *field = field_with(p_field);
	if (field == nullptr || found == _plots.end() || found->second.state != State::STANDING || found->second.field != p_field) {
		return; // a listener has freed it, or restarted the world
	}
	if (is_changed(found->second, *field)) {
		_files.write(p_key, kept_of(field->get_map()->get_map(), _fields.get_pattern().has_terrain));
	}
	if (!field->is_inside_tree()) {
		tell_once(_told_of_taken, p_key,
				"is no longer in the tree. Its changes are saved, and the field is yours: free it. The world shows another one when the "
				"plot "
				"is loaded again.");
	}
	_plots.erase(found);
	_statistics.left++;
	field->get_parts().settings.fit_pool(0); // it waits without slots
	field->get_parts().settings.fit_pool(_memory.find_most_slots());
	_fields.give_back(field, !_memory.is_exceeded());
}

bool WorldPlots::is_changed(const Plot &p_plot, const GrassField &p_field) const {
	const Ref<GrassMap> map = p_field.get_map();
	return map.is_valid() && map->is_readable() &&
			!is_same(kept_of(map->get_map(), _fields.get_pattern().has_terrain), kept_of(p_plot.known, _fields.get_pattern().has_terrain));
}

} // namespace grass
