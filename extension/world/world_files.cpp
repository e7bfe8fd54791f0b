// SPDX-License-Identifier: MIT
// The thread, what it is asked, and what is kept. The files themselves: world_files_disk.cpp.
#include "world/world_files.h"

#include "core/base/beside.h"
#include "shared/frames.h"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <chrono>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// Those that run, to find two that write to one folder. Main thread only.
std::map<const WorldFiles *, WorldFolders> running;

String real_path(const String &p_folder) {
	return ProjectSettings::get_singleton()->globalize_path(p_folder).simplify_path().rstrip("/");
}

} // namespace

void WorldFiles::start(const WorldFolders &p_folders) {
	stop();
	_folders = p_folders;
	_sizes.look(_folders.place);
	_folders.keeps = _folders.keeps || _sizes.has_wrong_to();
	running[this] = _folders;
	// Without a renderer only one thread may use the engine's list of textures (Godot 4.6: one leaked at exit in some runs).
	_makes_textures = draws_frames();
	if (HAS_THREADS) {
		_is_ending = _has_ended = false;
		_thread = run_beside([this] { work(); });
	}
}

void WorldFiles::stop() {
	running.erase(this);
	if (_thread.valid()) {
		{
			std::unique_lock lock(_mutex);
			_is_ending = true;
			_has_changed.notify_all();
			wait_until(lock, [this] { return _has_ended; });
		}
		_thread.get();
	}
	_read.clear();
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

// Adds a job. Outside the tree no thread runs, so it is done at once.
void WorldFiles::add(Job &&p_job) {
	if (!_thread.valid()) {
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

// Waits, and keeps the renderer in sync: the thread makes textures, and in some renderers that waits for the calling thread.
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

// Returns whether a place may be written: another place's maps would spoil those that this world has in the same folder.
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
	return statistics;
}

void WorldFiles::keep(const PlotsPlace &p_place, const PlotKey &p_key, const PackedByteArray &p_data) {
	std::lock_guard lock(_mutex);
	_kept.keep(p_place, p_key, p_data);
}

} // namespace grass
