// SPDX-License-Identifier: MIT
#include "gpu/knot_reader.h"

#include "compute_shaders.gen.h"
#include "gpu/render_queue.h"

#include <bit>
#include <cstring>

using namespace godot;

namespace grass {

namespace {

constexpr int64_t BLADE_BYTES = KNOT_NUMBERS * int64_t(sizeof(float));

std::vector<float> to_floats(const PackedByteArray &p_data) {
	std::vector<float> numbers(size_t(p_data.size()) / sizeof(float));
	if (!numbers.empty()) {
		std::memcpy(numbers.data(), p_data.ptr(), numbers.size() * sizeof(float));
	}
	return numbers;
}

} // namespace

const PassCode KnotReader::CODE = { shader::GATHER_SPIRV, "GrassField gather", PassOrder::GATHER };

void KnotReader::create() {
	_pass.create(CODE, GpuPass::Compile::LATER);
}

void KnotReader::bind(const RID &p_knots, const RID &p_halves) {
	_pass.bind_buffer(GRASS_GATHER_KNOTS, p_knots);
	_pass.bind_buffer(GRASS_GATHER_HALVES, p_halves);
}

// Returns how many bytes of _found contain the knots.
uint32_t KnotReader::gather(std::span<const WantedBlade> p_blades) {
	std::vector<uint32_t> places;
	places.reserve(p_blades.size());
	for (const WantedBlade &blade : p_blades) {
		places.push_back(uint32_t(blade.slot * GRASS_BLADES_PER_TILE + blade_in_tile(blade.number)));
	}
	const int64_t bytes = int64_t(places.size()) * BLADE_BYTES;
	_blades.upload(std::span<const uint32_t>(places));
	if (bytes > _found.size()) {
		_found.allocate(int64_t(std::bit_ceil(uint64_t(bytes))));
	}
	_pass.bind_buffer(GRASS_GATHER_BLADES, _blades.rid());
	_pass.bind_buffer(GRASS_GATHER_FOUND, _found.rid());
	const uvec4 count = { uint32_t(places.size()), 0, 0, 0 };
	const int64_t list = main_device()->compute_list_begin();
	_pass.dispatch(list, count, (count.x - 1) / GRASS_GATHER_GROUP + 1);
	main_device()->compute_list_end();
	return uint32_t(bytes);
}

void KnotReader::read_later(std::vector<WantedBlade> &&p_blades, uint64_t p_step, const std::shared_ptr<KnotReport> &r_report) {
	if (p_blades.empty() || !_pass.is_ready()) {
		return;
	}
	const uint32_t bytes = gather(p_blades);
	const auto receive = [report = r_report, blades = std::move(p_blades), p_step](const PackedByteArray &p_data) {
		if (p_data.size() != int64_t(blades.size()) * BLADE_BYTES) {
			return;
		}
		KnotWatch::Answer answer{ p_step, {}, to_floats(p_data) };
		answer.blades.reserve(blades.size());
		for (const WantedBlade &blade : blades) {
			answer.blades.push_back(blade.number);
		}
		std::lock_guard lock(report->mutex);
		report->answer = std::move(answer);
	};
	RenderQueue::get_singleton()->read_later(_found.rid(), bytes, receive);
}

std::vector<float> KnotReader::read_now(std::span<const WantedBlade> p_blades) {
	if (p_blades.empty()) {
		return {};
	}
	_pass.finish();
	if (!_pass.is_ready()) {
		return {};
	}
	const uint32_t bytes = gather(p_blades);
	std::vector<float> knots = to_floats(main_device()->buffer_get_data(_found.rid(), 0, bytes));
	return knots.size() * sizeof(float) == bytes ? knots : std::vector<float>();
}

void KnotReader::free() {
	_pass.free();
	_blades.free();
	_found.free();
}

} // namespace grass
