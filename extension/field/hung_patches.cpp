// SPDX-License-Identifier: MIT
#include "field/hung_patches.h"

#include "core/base/beside.h"
#include "core/solver/hang.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <vector>

namespace grass {

namespace {

struct Hanging {
	const Patch *of = nullptr; // only for comparison
	double frequency = 0.0, taper = 0.0, section = 0.0; // of the solver, as far as they matter
	std::array<double, 3> pull{};
	int stems = 1;
	bool operator==(const Hanging &) const = default;
};

struct Hung {
	Hanging hanging;
	std::weak_ptr<const Patch> of, made;
	std::shared_ptr<std::atomic<bool>> is_stopped = std::make_shared<std::atomic<bool>>(false);
	std::future<std::shared_ptr<const Patch>> making; // not valid once it was taken

	Hung() = default;
	Hung(Hung &&) = default;
	Hung &operator=(Hung &&) = default;
	~Hung() {
		if (is_stopped) {
			*is_stopped = true; // the future waits for its thread
		}
	}
	bool is_done() const { return !making.valid() || making.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
	bool is_unused() const { return of.expired() || (!making.valid() && made.expired()); }
};

Hung &begin(const std::shared_ptr<const Patch> &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems) {
	static std::vector<Hung> all;
	std::erase_if(all, [](const Hung &p_hung) { return p_hung.is_unused(); });
	const SolverParams solver = p_solver.sanitised();
	const Hanging hanging{ p_patch.get(), solver.natural_frequency, solver.taper, solver.width_to_thickness,
		{ p_pull.x(), p_pull.y(), p_pull.z() }, p_stems };
	const auto found = std::ranges::find(all, hanging, &Hung::hanging);
	if (found != all.end()) {
		return *found;
	}
	Hung &hung = all.emplace_back();
	hung.hanging = hanging;
	hung.of = p_patch;
	hung.making = run_beside([p_patch, solver, p_pull, p_stems, is_stopped = hung.is_stopped] {
		return std::make_shared<const Patch>(hang_patch(*p_patch, solver, p_pull, p_stems, is_stopped.get()));
	});
	return hung;
}

} // namespace

bool prepare_hung(const std::shared_ptr<const Patch> &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems) {
	return begin(p_patch, p_solver, p_pull, p_stems).is_done();
}

std::shared_ptr<const Patch> find_hung(
		const std::shared_ptr<const Patch> &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems) {
	Hung &hung = begin(p_patch, p_solver, p_pull, p_stems);
	if (!hung.making.valid()) {
		return hung.made.lock();
	}
	std::shared_ptr<const Patch> made = hung.making.get();
	hung.made = made;
	return made;
}

} // namespace grass
