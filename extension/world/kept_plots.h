// SPDX-License-Identifier: MIT
// Maps of plots that are not written yet, each with the place to which it belongs: plots of another level, save game or size are other
// plots.
#pragma once

#include "core/world/world_grid.h"

#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include <map>
#include <optional>
#include <utility>

namespace grass {

// The folders of a world's plots, and the size of the plots.
struct PlotsPlace {
	godot::String from, to; // folder of maps; folder for changed maps, which is searched first
	double plot_size = 0.0; // metres

	bool operator==(const PlotsPlace &) const = default;
	bool operator<(const PlotsPlace &p_other) const;
};

class KeptPlots {
public:
	using Maps = std::map<PlotKey, godot::PackedByteArray>; // in the format of their files

	void keep(const PlotsPlace &p_place, const PlotKey &p_key, const godot::PackedByteArray &p_data) { _maps[p_place][p_key] = p_data; }
	void forget(const PlotsPlace &p_place, const PlotKey &p_key);
	godot::PackedByteArray find(const PlotsPlace &p_place, const PlotKey &p_key) const; // empty: none
	// Returns everything that is kept, and forgets it.
	std::map<PlotsPlace, Maps> take() { return std::exchange(_maps, {}); }
	const std::map<PlotsPlace, Maps> &get() const { return _maps; }
	// Moves what belongs to other folders, of plots of the same size, to p_place. Returns the number of plots.
	int64_t carry(const PlotsPlace &p_place);
	// Forgets everything that does not belong to p_place.
	void keep_only(const PlotsPlace &p_place);
	int64_t count() const;
	int64_t count_elsewhere(const PlotsPlace &p_place) const;

private:
	std::map<PlotsPlace, Maps> _maps;
};

// The size of the plots for which folders were written. In a world with plots of 256 m, a file for plots of 128 m would be shown, and
// overwritten, at another place; so such a folder is neither read nor written.
class FoldersOfSize {
public:
	void look(const PlotsPlace &p_place);
	bool has_wrong_from() const { return _from.has_value(); }
	bool has_wrong_to() const { return _to.has_value(); }
	godot::String find_problem(const PlotsPlace &p_place) const; // "": none
	// Writes the size to a folder, before the first file is written there.
	static void mark(const godot::String &p_folder, double p_plot_size);

private:
	std::optional<double> _from, _to; // metres, if different
};

} // namespace grass
