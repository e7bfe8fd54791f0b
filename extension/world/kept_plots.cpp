// SPDX-License-Identifier: MIT
#include "world/kept_plots.h"

#include <godot_cpp/classes/file_access.hpp>

#include <tuple>

using namespace godot;

namespace grass {

namespace {

// A hidden file beside the maps: the side of their plots in metres. A folder without it is older than this file, or is packed.
constexpr char SIZE_FILE[] = ".plot_size";

std::optional<double> read_size(const String &p_folder) {
	const String path = p_folder.path_join(SIZE_FILE);
	if (p_folder.is_empty() || !FileAccess::file_exists(path)) {
		return {};
	}
	const double size = FileAccess::get_file_as_string(path).to_float();
	return size > 0.0 ? std::optional<double>(size) : std::nullopt;
}

std::optional<double> other_size(const String &p_folder, double p_size) {
	const std::optional<double> size = read_size(p_folder);
	return size != p_size ? size : std::nullopt;
}

} // namespace

bool PlotsPlace::operator<(const PlotsPlace &p_other) const {
	return std::tie(from, to, plot_size) < std::tie(p_other.from, p_other.to, p_other.plot_size);
}

void KeptPlots::forget(const PlotsPlace &p_place, const PlotKey &p_key) {
	if (const auto found = _maps.find(p_place); found != _maps.end()) {
		found->second.erase(p_key);
		if (found->second.empty()) {
			_maps.erase(found);
		}
	}
}

PackedByteArray KeptPlots::find(const PlotsPlace &p_place, const PlotKey &p_key) const {
	const auto maps = _maps.find(p_place);
	const auto found = maps != _maps.end() ? maps->second.find(p_key) : Maps::const_iterator();
	return maps != _maps.end() && found != maps->second.end() ? found->second : PackedByteArray();
}

int64_t KeptPlots::carry(const PlotsPlace &p_place) {
	int64_t count = 0;
	Maps carried;
	for (auto next = _maps.begin(); next != _maps.end();) {
		const auto here = next++;
		if (!(here->first == p_place) && here->first.plot_size == p_place.plot_size) {
			count += int64_t(here->second.size());
			carried.merge(here->second);
			_maps.erase(here);
		}
	}
	for (auto &[key, data] : carried) {
		keep(p_place, key, data);
	}
	return count;
}

void KeptPlots::keep_only(const PlotsPlace &p_place) {
	std::erase_if(_maps, [&](const auto &p_entry) { return !(p_entry.first == p_place); });
}

int64_t KeptPlots::count() const {
	int64_t count = 0;
	for (const auto &[place, maps] : _maps) {
		count += int64_t(maps.size());
	}
	return count;
}

int64_t KeptPlots::count_elsewhere(const PlotsPlace &p_place) const {
	const auto here = _maps.find(p_place);
	return count() - (here != _maps.end() ? int64_t(here->second.size()) : 0);
}

void FoldersOfSize::look(const PlotsPlace &p_place) {
	_from = other_size(p_place.from, p_place.plot_size);
	_to = other_size(p_place.to, p_place.plot_size);
}

String FoldersOfSize::find_problem(const PlotsPlace &p_place) const {
	if (!_from && !_to) {
		return String();
	}
	const bool is_folder = !_to || p_place.to == p_place.from;
	return vformat(
			"`%s` ('%s') holds plots of %d m, but `plot_size` is %d m, so its files are neither read nor written. Set `plot_size` to "
			"%d, or choose another folder.",
			String(is_folder ? "folder" : "save_folder"), is_folder ? p_place.from : p_place.to, int64_t(_to ? *_to : *_from),
			int64_t(p_place.plot_size), int64_t(_to ? *_to : *_from));
}

void FoldersOfSize::mark(const String &p_folder, double p_plot_size) {
	const String path = p_folder.path_join(SIZE_FILE);
	if (FileAccess::file_exists(path)) {
		return;
	}
	if (const Ref<FileAccess> file = FileAccess::open(path, FileAccess::WRITE); file.is_valid()) { // else the map says what is wrong
		file->store_string(String::num_int64(int64_t(p_plot_size)) + String("\n"));
	}
}

} // namespace grass
