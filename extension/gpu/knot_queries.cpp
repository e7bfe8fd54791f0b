// SPDX-License-Identifier: MIT
#include "gpu/knot_queries.h"

#include "gpu/gpu_field.h"

#include <godot_cpp/classes/rendering_server.hpp>

using namespace godot;

namespace grass {

KnotQueries::KnotQueries(FieldJobs &p_jobs) : _jobs(p_jobs), _report(std::make_shared<KnotReport>()) {}

// Replies that are still on their way belong to the old field.
void KnotQueries::clear() {
	_watch.clear();
	_report = std::make_shared<KnotReport>();
}

void KnotQueries::take_knots() {
	KnotWatch::Answer answer;
	{
		std::lock_guard lock(_report->mutex);
		answer = std::exchange(_report->answer, {});
	}
	if (answer.step != 0) {
		_watch.receive(std::move(answer));
	}
}

std::vector<SimulatedKnots> KnotQueries::find_knots(std::span<const WantedBlade> p_blades) {
	take_knots();
	std::vector<SimulatedKnots> found;
	found.reserve(p_blades.size());
	for (const WantedBlade &blade : p_blades) {
		found.push_back(_watch.ask(blade));
	}
	return found;
}

void KnotQueries::read_asked(const Backend::SlotOf &p_slot_of, uint64_t p_step) {
	if (!_watch.is_due(p_step)) {
		return;
	}
	std::vector<WantedBlade> blades = _watch.begin_read(p_step, p_slot_of);
	if (!blades.empty()) {
		_read += int64_t(blades.size());
		_jobs.post([wanted = std::move(blades), step = p_step, report = _report](
						   GpuField &r_field) mutable { r_field.get_reader().read_later(std::move(wanted), step, report); });
	}
}

std::vector<SimulatedKnots> KnotQueries::wait_for_knots(std::span<const WantedBlade> p_blades) {
	std::vector<WantedBlade> awake(p_blades.begin(), p_blades.end());
	std::erase_if(awake, [](const WantedBlade &p_blade) { return p_blade.slot == GRASS_NO_SLOT; });
	auto numbers = std::make_shared<std::vector<float>>();
	if (!awake.empty()) {
		_waits++;
		_jobs.post([numbers, awake](GpuField &r_field) { *numbers = r_field.get_reader().read_now(awake); });
		RenderingServer::get_singleton()->force_sync(); // where the render thread is another one, it owns `numbers` until then
	}
	std::vector<SimulatedKnots> found(p_blades.size());
	const float *from = numbers->data();
	for (size_t i = 0; i < found.size() && !numbers->empty(); i++) {
		if (p_blades[i].slot != GRASS_NO_SLOT) {
			found[i] = unpack_knots(from);
			from += KNOT_NUMBERS;
		}
	}
	return found;
}

void KnotQueries::add_to(BackendStatistics &r_statistics, uint64_t p_step) {
	take_knots();
	r_statistics.knots_read = _read;
	r_statistics.knot_waits = _waits;
	r_statistics.knots_age = _watch.get_age(p_step);
}

} // namespace grass
