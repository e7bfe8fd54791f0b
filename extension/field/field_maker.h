// SPDX-License-Identifier: MIT
// From properties to a field. One that enters the tree is made at once, so that its grass stands from the first tick on, unless it is
// streamed. A field that stands goes on until everything slow has been made beside it: patches and passes by other threads, shaders and the
// map piece by piece, as frames have time (draw/frame_share.h).
#pragma once

#include "core/field/field.h"
#include "core/field/field_statistics.h"
#include "draw/backend.h"
#include "field/field_properties.h"
#include "field/shown_map.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace grass {

// The field that properties describe, as far as it is prepared. The running field does not read it.
struct WantedField {
	FieldSetup setup;
	std::vector<SpeciesParams> mix;
	std::vector<GrownSpecies> species;
	std::vector<DrawnPlant> plants; // of the species
	std::shared_ptr<TileBounds> bounds; // null: not prepared yet
	godot::Ref<GrassMap> painted; // what `map` is to show; null: none
	std::unique_ptr<ShownMap> map; // null: none, or not begun yet
};

class FieldMaker {
public:
	// However many properties change, the field is made once, at the next tick or frame. What is being made goes on and is shown, and is
	// made anew then: properties that change in every frame still show.
	void request();
	// The map that the field is to show, prepared by another thread; null: none.
	void offer(std::unique_ptr<PreparedMap> p_prepared) { _prepared = std::move(p_prepared); }
	bool is_waiting() const { return _is_waiting; }
	// Prepares it; beside a field that stands (p_backend), as far as this frame has time. True once it can be made.
	bool prepare(const FieldProperties &p_properties, const Field &p_now, Backend *p_backend);
	// For what a map would have to be prepared; nothing while the patches are not made yet.
	static std::optional<ShownPlace> find_place(const FieldProperties &p_properties);
	// The field that was prepared, to be made now.
	WantedField take();
	void forget() { drop(); }

	ShownMap *get_map() const { return _wanted ? _wanted->map.get() : nullptr; } // that waits to be shown, or null
	// Milliseconds that the making took in one frame, at most, since request().
	void add_time(double p_ms);
	double get_most_ms() const { return _most_ms; }
	int64_t get_memory_usage() const { return get_map() != nullptr ? get_map()->get_memory_usage() : 0; } // bytes
	void add_to(FieldStatistics &r_statistics) const;

private:
	static WantedField find_wanted(const FieldProperties &p_properties);
	bool prepare_map(const std::function<bool()> &p_has_time);
	void drop();

	bool _is_waiting = false;
	std::unique_ptr<PreparedMap> _prepared;
	std::optional<WantedField> _wanted; // once it is known what the properties make
	bool _is_stale = false; // they changed after that
	double _most_ms = 0.0; // of add_time()
	int64_t _makings = 0; // so far
};

} // namespace grass
