// SPDX-License-Identifier: MIT
// Makes a field from its properties. A field that enters the tree is made at once, so that its grass is drawn from the first tick on,
// unless it is streamed. A field that already runs continues until everything slow has been made beside it: other threads make patches
// and passes; shaders and the map are made piece by piece, as frames have time (draw/frame_share.h).
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

// The field that the properties describe, as far as it is prepared. The running field does not read it.
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
	// Requests that the field be made at the next tick or frame, once, however many properties change. A field that is being made is
	// finished and shown first, and then made again, so properties that change in every frame still take effect.
	void request();
	// Sets the map that the field will show, prepared by another thread; null: none.
	void offer(std::unique_ptr<PreparedMap> p_prepared) { _prepared = std::move(p_prepared); }
	bool is_waiting() const { return _is_waiting; }
	// Prepares the field. Beside a running field (p_backend), only as far as this frame has time. Returns true once it can be made.
	bool prepare(const FieldProperties &p_properties, const Field &p_now, Backend *p_backend);
	// Returns where a map would be shown, in order to prepare it, or nothing while the patches are not made yet.
	static std::optional<ShownPlace> find_place(const FieldProperties &p_properties);
	// Returns the prepared field, to be made now.
	WantedField take();
	void forget() { drop(); }

	ShownMap *get_map() const { return _wanted ? _wanted->map.get() : nullptr; } // that waits to be shown, or null
	// Records the milliseconds that making the field took in one frame; get_most_ms() is their maximum since request().
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
