// SPDX-License-Identifier: MIT
// Answers scripts that query where blades on the GPU are: with the knots that were read back last, or after a wait. Main thread only.
#pragma once

#include "core/field/backend_statistics.h"
#include "core/field/knot_watch.h"
#include "draw/backend.h"
#include "gpu/field_jobs.h"

namespace grass {

struct KnotReport;

class KnotQueries {
public:
	explicit KnotQueries(FieldJobs &p_jobs);

	// Do what Backend's functions of these names do. p_step: the newest.
	std::vector<SimulatedKnots> find_knots(std::span<const WantedBlade> p_blades);
	std::vector<SimulatedKnots> wait_for_knots(std::span<const WantedBlade> p_blades);
	void read_asked(const Backend::SlotOf &p_slot_of, uint64_t p_step);
	// Starts again with the blades of another field.
	void clear();
	void add_to(BackendStatistics &r_statistics, uint64_t p_step);
	size_t get_memory_usage() const { return _watch.get_memory_usage(); } // bytes

private:
	void take_knots();

	FieldJobs &_jobs;
	KnotWatch _watch;
	std::shared_ptr<KnotReport> _report; // of the running field
	int64_t _read = 0, _waits = 0; // see BackendStatistics
};

} // namespace grass
