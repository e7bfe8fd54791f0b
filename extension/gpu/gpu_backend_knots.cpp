// SPDX-License-Identifier: MIT
// What GpuBackend does for scripts that ask where blades are.
#include "gpu/gpu_backend.h"
#include "gpu/gpu_field.h"

#include <godot_cpp/classes/rendering_server.hpp>

using namespace godot;

namespace grass {

void GpuBackend::take_knots() {
	KnotWatch::Answer answer;
	{
		std::lock_guard lock(_knot_report->mutex);
		answer = std::exchange(_knot_report->answer, {});
	}
	if (answer.step != 0) {
		_watch.receive(std::move(answer));
	}
}

std::vector<SimulatedKnots> GpuBackend::find_knots(std::span<const WantedBlade> p_blades) {
	take_knots();
	std::vector<SimulatedKnots> found;
	found.reserve(p_blades.size());
	for (const WantedBlade &blade : p_blades) {
		found.push_back(_watch.ask(blade));
	}
	return found;
}

void GpuBackend::read_asked(const SlotOf &p_slot_of) {
	if (!_watch.is_due(_steps)) {
		return;
	}
	std::vector<WantedBlade> blades = _watch.begin_read(_steps, p_slot_of);
	if (!blades.empty()) {
		_knots_read += int64_t(blades.size());
		post([wanted = std::move(blades), step = _steps, report = _knot_report](
					 GpuField &r_field) mutable { r_field.get_reader().read_later(std::move(wanted), step, report); });
	}
}

std::vector<SimulatedKnots> GpuBackend::wait_for_knots(std::span<const WantedBlade> p_blades) {
	std::vector<WantedBlade> awake(p_blades.begin(), p_blades.end());
	std::erase_if(awake, [](const WantedBlade &p_blade) { return p_blade.slot == GRASS_NO_SLOT; });
	auto numbers = std::make_shared<std::vector<float>>();
	if (!awake.empty()) {
		_knot_waits++;
		post([numbers, awake](GpuField &r_field) { *numbers = r_field.get_reader().read_now(awake); });
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

} // namespace grass
