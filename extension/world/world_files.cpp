// SPDX-License-Identifier: MIT
#include "world/world_files.h"

#include "resources/grass_map_file.h"
#include "resources/size_limits.h"
#include "shared/convert.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/display_server.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <chrono>
#include <limits>
#include <utility>

using namespace godot;

namespace grass {

namespace {

std::string name_of(const String &p_path) {
	return p_path.utf8().get_data();
}

// Those that run, to find two that write to one folder. Main thread only.
std::map<const WorldFiles *, WorldFolders> running;

String real_path(const String &p_folder) {
	return ProjectSettings::get_singleton()->globalize_path(p_folder).simplify_path().rstrip("/");
}

// A name that no file has: what was put aside before stays.
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

void WorldFiles::start(const WorldFolders &p_folders) {
	stop();
	_folders = p_folders;
	_sizes.look(_folders.place);
	_folders.keeps = _folders.keeps || _sizes.has_wrong_to();
	running[this] = _folders;
	// Without a renderer the engine's list of textures is no other thread's (Godot 4.6: one leaked at exit in some runs).
	_makes_textures = DisplayServer::get_singleton()->get_name() != "headless";
	_is_ending = _has_ended = false;
	_thread = std::thread([this] { work(); });
}

void WorldFiles::stop() {
	running.erase(this);
	if (_thread.joinable()) {
		{
			std::unique_lock lock(_mutex);
			_is_ending = true;
			_has_changed.notify_all();
			wait_until(lock, [this] { return _has_ended; });
		}
		_thread.join();
		_read.clear();
	}
}

void WorldFiles::work() {
	std::unique_lock lock(_mutex);
	while (true) {
		_has_changed.wait(lock, [this] { return _is_ending || !_jobs.empty(); });
		if (_jobs.empty()) {
			_has_ended = true;
			_has_changed.notify_all();
			return;
		}
		const Job job = std::move(_jobs.front());
		if (!job.is_read || !_is_ending) {
			lock.unlock();
			job.run();
			lock.lock();
		}
		_jobs.pop_front();
		_has_changed.notify_all();
	}
}

// Out of the tree no thread runs: what is to be written then is written here.
void WorldFiles::add(Job &&p_job) {
	if (!_thread.joinable()) {
		p_job.run();
		return;
	}
	{
		std::lock_guard lock(_mutex);
		_jobs.push_back(std::move(p_job));
	}
	_has_changed.notify_all();
}

void WorldFiles::wait() {
	std::unique_lock lock(_mutex);
	wait_until(lock, [this] { return _jobs.empty() || _has_ended; });
}

// The thread makes textures, and in some renderers that waits for this very thread.
void WorldFiles::wait_until(std::unique_lock<std::mutex> &r_lock, const std::function<bool()> &p_is_done) {
	while (!_has_changed.wait_for(r_lock, std::chrono::milliseconds(1), p_is_done)) {
		r_lock.unlock();
		RenderingServer::get_singleton()->force_sync();
		r_lock.lock();
	}
}

void WorldFiles::read(const PlotKey &p_key, int64_t p_ask, const PaintMap &p_default, const MapPlace &p_place) {
	add({ true, [this, p_key, p_ask, p_default, p_place] {
			 ReadPlot plot{ p_key, p_ask, find(p_key, p_default), nullptr };
			 plot.prepared = std::make_unique<ShownMap>(p_place);
			 plot.prepared->prepare(plot.map, _makes_textures);
			 std::lock_guard lock(_mutex);
			 _read.push_back(std::move(plot));
		 } });
}

void WorldFiles::write(const PlotKey &p_key, const PaintMap &p_map) {
	add({ false, [this, p_key, p_map] { put(p_key, p_map); } });
}

void WorldFiles::change(const PlotKey &p_key, const PaintMap &p_default, const std::function<void(PaintMap &)> &p_change) {
	add({ false, [this, p_key, p_default, p_change] {
			 PaintMap map = find(p_key, p_default);
			 p_change(map);
			 put(p_key, map);
		 } });
}

void WorldFiles::put(const PlotKey &p_key, const PaintMap &p_map) {
	const PackedByteArray data = to_bytes(std::span<const uint8_t>(write_map(p_map, engine_codec())));
	if (_folders.keeps) {
		keep(_folders.place, p_key, data);
	} else {
		write_file(_folders.place, p_key, data);
	}
}

// Another place's maps would spoil those that this world has in the same folder.
bool WorldFiles::may_write(const PlotsPlace &p_place) const {
	return !p_place.to.is_empty() &&
			(p_place == _folders.place ? !_sizes.has_wrong_to() : real_path(p_place.to) != real_path(_folders.place.to));
}

void WorldFiles::write_kept() {
	add({ false, [this] {
			 std::map<PlotsPlace, KeptPlots::Maps> kept;
			 {
				 std::lock_guard lock(_mutex);
				 kept = _kept.take();
			 }
			 for (const auto &[place, maps] : kept) {
				 for (const auto &[key, data] : maps) {
					 if (may_write(place)) {
						 write_file(place, key, data);
					 } else {
						 keep(place, key, data);
					 }
				 }
			 }
		 } });
}

int64_t WorldFiles::carry_kept() {
	std::lock_guard lock(_mutex);
	return _kept.carry(_folders.place);
}

int64_t WorldFiles::discard_kept() {
	std::lock_guard lock(_mutex);
	const int64_t count = _kept.count();
	_kept = {};
	return count;
}

void WorldFiles::discard_kept_elsewhere() {
	std::lock_guard lock(_mutex);
	_kept.keep_only(_folders.place);
}

int64_t WorldFiles::count_writable() const {
	std::lock_guard lock(_mutex);
	int64_t count = 0;
	for (const auto &[place, maps] : _kept.get()) {
		count += may_write(place) ? int64_t(maps.size()) : 0;
	}
	return count;
}

String WorldFiles::find_problem() const {
	if (String problem = _sizes.find_problem(_folders.place); !problem.is_empty()) {
		return problem;
	}
	for (const auto &[files, folders] : running) {
		if (files != this && !_folders.place.to.is_empty() && real_path(folders.place.to) == real_path(_folders.place.to)) {
			return vformat("%s writes its plots to '%s', too, so each of the two worlds overwrites the files of the other. Give each world "
						   "its own `folder` and `save_folder`.",
					folders.label, _folders.place.to);
		}
	}
	return String();
}

std::vector<ReadPlot> WorldFiles::take_read() {
	std::lock_guard lock(_mutex);
	return std::exchange(_read, {});
}

WorldFileStatistics WorldFiles::get_statistics() const {
	std::lock_guard lock(_mutex);
	WorldFileStatistics statistics = _statistics;
	statistics.waiting = int64_t(_jobs.size());
	statistics.kept = _kept.count();
	statistics.kept_elsewhere = _kept.count_elsewhere(_folders.place);
	statistics.bytes_kept = _kept.count_bytes();
	return statistics;
}

void WorldFiles::keep(const PlotsPlace &p_place, const PlotKey &p_key, const PackedByteArray &p_data) {
	std::lock_guard lock(_mutex);
	_kept.keep(p_place, p_key, p_data);
}

// A plot's map covers the plot, and what blends into its border.
ReadLimits WorldFiles::limits() const {
	ReadLimits limits = get_read_limits();
	const double half = 0.5 * _folders.place.plot_size;
	limits.regions.push_back(MapRegion{ { -half, -half }, { half, half } }.grown(MAP_CHUNK_SIZE));
	return limits;
}

// What is kept is newer than any file.
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

// False, and r_map stays as it was, where there is none that can be read.
bool WorldFiles::read_file(const String &p_path, PaintMap &r_map) {
	if (!FileAccess::file_exists(p_path)) {
		return false;
	}
	const PackedByteArray bytes = FileAccess::get_file_as_bytes(p_path);
	const std::string reason = read_map(std::span(bytes.ptr(), size_t(bytes.size())), engine_codec(), r_map, limits());
	if (!reason.empty()) {
		ERR_PRINT(vformat("%s: `folder` has a map that cannot be read: the file '%s' %s. Its plot is used as if it had no file. The file "
						  "stays as it is, and is renamed to '%s.unread' once the plot is changed.",
				_folders.label, p_path, String(reason.c_str()), p_path.get_file()));
	}
	std::lock_guard lock(_mutex);
	_statistics.read += reason.empty() ? 1 : 0;
	_statistics.refused += reason.empty() ? 0 : 1;
	_statistics.bytes_read += bytes.size();
	if (!reason.empty()) {
		_refused.insert(name_of(p_path));
	}
	return reason.empty();
}

// What cannot be written is kept.
void WorldFiles::write_file(const PlotsPlace &p_place, const PlotKey &p_key, const PackedByteArray &p_data) {
	const String path = path_of(p_place.to, p_key);
	bool is_refused = false;
	{
		std::lock_guard lock(_mutex);
		is_refused = _refused.erase(name_of(path)) > 0;
	}
	if (is_refused) {
		DirAccess::rename_absolute(path, unread_path(path));
	}
	const bool has_folder = !p_place.to.is_empty() && DirAccess::make_dir_recursive_absolute(p_place.to) == OK;
	if (has_folder) {
		FoldersOfSize::mark(p_place.to, p_place.plot_size);
	}
	if (!has_folder || write_map_file(p_data, path) != OK) {
		ERR_PRINT(vformat("%s: plot (%d, %d) cannot be written to `%s`. It stays in memory until save() can write it.", _folders.label,
				p_key.x, p_key.z, p_place.to));
		keep(p_place, p_key, p_data);
		return;
	}
	std::lock_guard lock(_mutex);
	_kept.forget(p_place, p_key); // of a write that failed
	_statistics.written++;
	_statistics.bytes_written += p_data.size();
}

} // namespace grass
