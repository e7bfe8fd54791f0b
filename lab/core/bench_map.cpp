// SPDX-License-Identifier: MIT
// What a step of a brush costs on a painted map of 1 km^2, as CSV on stdout: strokes of 1 m steps across it.
// Then what a step of recovery costs in which a chunk heals, trampled in a path of 4 m or all over.
#include "core/paint/recovery.h"
#include "core/species/species.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

using namespace grass;

namespace {

constexpr int STEPS = 400;

void fill(PaintMap &r_map, double p_side) {
	const Eigen::Vector2d corners[] = { { -0.5 * p_side, -0.5 * p_side }, { 0.5 * p_side, -0.5 * p_side }, { 0.5 * p_side, 0.5 * p_side },
		{ -0.5 * p_side, 0.5 * p_side } };
	Brush brush;
	brush.target = 0.7;
	apply_brush(r_map, MapShape(corners, 0.0), brush);
}

void run(PaintMap &r_map, const char *p_name, MapTool p_tool, double p_target, double p_radius) {
	std::vector<double> times;
	size_t chunks = 0, bytes = 0;
	for (int step = 0; step < STEPS; step++) {
		const Eigen::Vector2d from(step - 0.5 * STEPS, 0.3 * step), to = from + Eigen::Vector2d(1.0, 0.3);
		Brush brush;
		brush.tool = p_tool;
		brush.target = p_target;
		brush.strength = 0.3;
		brush.direction = to - from;
		const auto begin = std::chrono::steady_clock::now();
		const BrushResult result = apply_brush(r_map, MapShape::stroke(from, to, p_radius, 0.5, Falloff::SMOOTH), brush);
		const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
		times.push_back(time.count());
		chunks += result.changed.size();
		bytes += result.changed.size() * info_of(channel_of(brush)).chunk_bytes();
	}
	std::sort(times.begin(), times.end());
	std::printf("%s,%g,%.1f,%.1f,%.2f,%.0f\n", p_name, p_radius, times[STEPS / 2], times[STEPS * 99 / 100], double(chunks) / STEPS,
			double(bytes) / STEPS);
}

void run_recovery(const char *p_name, int p_species, double p_width) {
	PaintMap map;
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	apply_brush(map, MapShape::stroke({ 0, 32 }, { 64, 32 }, 0.5 * p_width, 1.0, Falloff::LINEAR), brush);
	const TileGrid grid = TileGrid::make(128.0, 128.0, 256.0);
	const SpeciesMix mix(std::vector<SpeciesParams>(size_t(p_species)), grid, 1);
	const SharesAt shares = [&](const Eigen::Vector2d &p_place) { return mix.get_shares_at(p_place.cast<float>(), nullptr); };
	RecoveryRates rates;
	rates.wear.fill(info_of(MAP_WEAR).unit); // a code a second, and a second a step
	const MapRegion chunk{ { 0, 0 }, { 64, 64 } };
	Recovery recovery;
	std::vector<double> times;
	for (int step = 0; step < 200; step++) {
		const auto begin = std::chrono::steady_clock::now();
		const BrushResult result = recovery.step(map, chunk, { 0.4, 0.9, 256.0, {} }, rates, 1.0, p_species > 1 ? shares : nullptr);
		const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
		if (!result.changed.empty()) {
			times.push_back(time.count());
		}
	}
	std::sort(times.begin(), times.end());
	std::printf("%s,%d,%.0f,%.0f\n", p_name, p_species, times[times.size() / 2], times[times.size() * 99 / 100]);
}

} // namespace

int main() {
	PaintMap map;
	fill(map, 1000.0);
	std::printf("# %zu chunks, %zu bytes\n", map.get_chunks().size(), map.get_memory_usage());
	std::printf("tool,radius_m,step_us_median,step_us_p99,chunks_a_step,bytes_of_them\n");
	for (const double radius : { 1.0, 5.0, 20.0 }) {
		run(map, "density", MapTool::DENSITY, 0.2, radius);
		run(map, "smooth", MapTool::SMOOTH, 0.0, radius);
		run(map, "tint", MapTool::TINT, 1.0, radius);
		run(map, "comb", MapTool::COMB, 1.0, radius);
		run(map, "cut", MapTool::CUT, 0.05, radius);
	}
	std::printf("recovery,species,step_us_median,step_us_p99\n");
	for (const int species : { 1, 2, 8 }) {
		run_recovery("path", species, 4.0);
		run_recovery("all", species, 200.0);
	}
}
