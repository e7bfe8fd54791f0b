// SPDX-License-Identifier: MIT
// The files of plots: how they are found, read and written.
#include "world/world_files.h"

#include "core/world/plot_map.h"
#include "resources/grass_map_file.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <limits>

using namespace godot;

namespace grass {

namespace {

std::string name_of(const String &p_path) {
	return p_path.utf8().get_data();
}

// Returns a name that no file has: what was put aside before stays.
String unread_path(const String &p_path) {
	String path = p_path + String(".unread");
	for (int64_t n = 2; FileAccess::file_exists(path); n++) {
		path = vformat("%s.unread%d", p_path, n);
	}
	return path;
}

} // namespace

String WorldFiles::path_of(const String &p_folder, const PlotKey &p_key) {
	return p_folder.path_join(vformat("plot_%d_%d.grassmap", p_key.x, p_key.z));
}

PackedStringArray WorldFiles::find_plots(const String &p_folder) {
	PackedStringArray plots;
	if (DirAccess::dir_exists_absolute(p_folder)) {
		for (const String &file : DirAccess::get_files_at(p_folder)) {
			if (file.get_extension() == "grassmap") {
				plots.push_back(p_folder.path_join(file));
			}
		}
	}
	return plots;
}

// Keeps or writes a map, without what lies outside of the plot: a file with that would be refused.
void WorldFiles::put(const PlotKey &p_key, const PaintMap &p_map) {
	PaintMap map = p_map;
	if (const int64_t count = crop(map, limits()); count > 0) {
		ERR_PRINT(vformat("%s: the map of plot (%d, %d) has %d chunks outside of the plot, which are not saved. Paint each plot within its "
						  "borders: GrassWorld.paint() and cut() do.",
				_folders.label, p_key.x, p_key.z, count));
	}
	const PackedByteArray data = to_bytes(std::span<const uint8_t>(write_map(map, engine_codec())));
	if (_folders.keeps) {
		keep(_folders.place, p_key, data);
	} else {
		write_file(_folders.place, p_key, data);
	}
}

// Returns the limits of a plot's map, which covers the plot and what blends into its border.
ReadLimits WorldFiles::limits() const {
	ReadLimits limits = get_read_limits();
	const double half = 0.5 * _folders.place.plot_size;
	limits.regions.push_back(MapRegion{ { -half, -half }, { half, half } }.grown(MAP_CHUNK_SIZE));
	return limits;
}

// Returns a plot's map. One that is kept is newer than any file.
PaintMap WorldFiles::find(const PlotKey &p_key, const PaintMap &p_default) {
	PackedByteArray kept;
	{
		std::lock_guard lock(_mutex);
		kept = _kept.find(_folders.place, p_key);
	}
	const String from = _sizes.has_wrong_from() ? String() : _folders.place.from, to = _sizes.has_wrong_to() ? String() : _folders.place.to;
	PaintMap map = p_default;
	if (!kept.is_empty()) {
		ReadLimits own; // what this world painted
		own.map_bytes = std::numeric_limits<size_t>::max();
		read_map(std::span(kept.ptr(), size_t(kept.size())), engine_codec(), map, own);
	} else if (to.is_empty() || !read_file(path_of(to, p_key), map)) {
		if (!from.is_empty() && from != to) {
			read_file(path_of(from, p_key), map);
		}
	}
	return map;
}

// Reads a file. Returns false, and leaves r_map as it was, if there is none that can be read.
bool WorldFiles::read_file(const String &p_path, PaintMap &r_map) {
	if (!FileAccess::file_exists(p_path)) {
		return false;
	}
	const PackedByteArray bytes = FileAccess::get_file_as_bytes(p_path);
	const std::string reason = read_map(std::span(bytes.ptr(), size_t(bytes.size())), engine_codec(), r_map, limits());
	if (!reason.empty()) {
		ERR_PRINT(vformat("%s: `folder` has a map that cannot be read: the file '%s' %s. Its plot is used as if it had no file. The file "
						  "stays as it is, and is renamed to '%s.unread' once the plot is changed.",
				_folders.label, p_path, text_of(reason), p_path.get_file()));
	}
	std::lock_guard lock(_mutex);
	_statistics.read += reason.empty() ? 1 : 0;
	_statistics.refused += reason.empty() ? 0 : 1;
	if (!reason.empty()) {
		_refused.insert(name_of(p_path));
	}
	return reason.empty();
}

// Writes a file. A map that cannot be written is kept.
void WorldFiles::write_file(const PlotsPlace &p_place, const PlotKey &p_key, const PackedByteArray &p_data) {
	const String path = path_of(p_place.to, p_key);
	bool is_refused = false;
	{
		std::lock_guard lock(_mutex);
		is_refused = _refused.erase(name_of(path)) > 0;
	}
	const bool is_aside = !is_refused || DirAccess::rename_absolute(path, unread_path(path)) == OK;
	if (!is_aside) { // the file is in use, or may not be moved
		std::lock_guard lock(_mutex);
		_refused.insert(name_of(path));
	}
	const bool has_folder = !p_place.to.is_empty() && DirAccess::make_dir_recursive_absolute(p_place.to) == OK;
	if (has_folder) {
		FoldersOfSize::mark(p_place.to, p_place.plot_size);
	}
	if (!is_aside || !has_folder || write_map_file(p_data, path) != OK) {
		ERR_PRINT(vformat("%s: plot (%d, %d) cannot be written to `%s`. It stays in memory until save() can write it.", _folders.label,
				p_key.x, p_key.z, p_place.to));
		keep(p_place, p_key, p_data);
		return;
	}
	std::lock_guard lock(_mutex);
	_kept.forget(p_place, p_key); // of a write that failed
	_statistics.written++;
}

} // namespace grass
