// SPDX-License-Identifier: MIT
// What tile management costs a step, as CSV on stdout: balls of 0.3 to 1 m rolling over fields of many sizes, 600
// steps at 60 Hz after 3 s of run-up, so that as many tiles fall asleep as wake. A camera sees all of it. Once with nothing
// else running, once with other memory written between steps, as the rest of a game does.
#include "core/tiles/tiles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

using namespace grass;

namespace {

constexpr double DELTA = 1.0 / 60.0; // seconds
constexpr int WARM_STEPS = 180, STEPS = 600;
constexpr size_t OTHER_MEMORY = size_t(64) << 20; // bytes: more than the caches hold

std::vector<ColliderShape> make_balls(int p_count, double p_extent, std::mt19937 &r_random) {
	std::uniform_real_distribution<double> place(-p_extent, p_extent), radius(0.15, 0.5);
	std::vector<ColliderShape> balls(static_cast<size_t>(p_count));
	for (ColliderShape &ball : balls) {
		ball.size.x() = radius(r_random);
		ball.now.position = { place(r_random), ball.size.x(), place(r_random) };
	}
	return balls;
}

// Each ball runs on at its own pace of 1 to 5 m/s and turns back at the border.
void move_balls(std::vector<ColliderShape> &r_balls, int p_step, double p_extent) {
	for (size_t i = 0; i < r_balls.size(); i++) {
		const double angle = double(i) * 2.4, speed = 1.0 + double(i % 5), phase = p_step * DELTA * speed;
		const auto fold = [p_extent](double p_x) { return p_extent - std::abs(std::remainder(p_x, 4.0 * p_extent)); };
		ColliderShape &ball = r_balls[i];
		ball.before = ball.now;
		ball.now.position.x() = fold(double(i) * 1.7 + phase * std::cos(angle));
		ball.now.position.z() = fold(double(i) * 3.1 + phase * std::sin(angle));
		ball.before = p_step == 0 ? ball.now : ball.before;
	}
}

// Returns a frustum of planes that are tested, with all of the crowd inside.
Frustum see_all() {
	Frustum frustum;
	for (size_t i = 0; i < frustum.size(); i++) {
		const float sign = i % 2 == 0 ? 1.0f : -1.0f;
		frustum[i] = Eigen::Vector4f::Zero();
		frustum[i][Eigen::Index(i / 2)] = sign;
		frustum[i].w() = 100.0f;
	}
	return frustum;
}

void run(double p_size, int p_count, std::vector<uint64_t> &r_other) {
	TileManager manager;
	const TileGrid grid = TileGrid::make(p_size, p_size, 256.0);
	static const Patch patch = generate_patch(PatchParams());
	const auto bounds = std::make_shared<const TileBounds>(patch, grid, ClumpParams(), 0);
	TileParams params;
	params.overhang = bounds->get_overhang();
	params.height = bounds->get_height();
	manager.set_grid(grid);
	manager.set_params(params);
	manager.set_bounds(bounds);
	const Frustum frustum = see_all();
	manager.get_view().see(std::span(&frustum, 1), 3.0f);
	const std::vector<float> lively(size_t(params.pool_size), 1.0f); // J/kg: tiles sleep by the timer, the pool is full
	std::mt19937 random(1);
	const double extent = 0.5 * std::min(p_size, 70.0); // the crowd stays together on any field
	std::vector<ColliderShape> balls = make_balls(p_count, extent, random);
	std::vector<double> times;
	double awake = 0.0, entries = 0.0;
	for (int step = 0; step < WARM_STEPS + STEPS; step++) {
		move_balls(balls, step, extent);
		for (uint64_t &word : r_other) { // read, too: what is only written may pass the caches by
			word++;
		}
		const auto begin = std::chrono::steady_clock::now();
		manager.report_energy({ manager.get_step_number(), lively });
		manager.update(DELTA, balls);
		const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
		if (step >= WARM_STEPS) {
			times.push_back(time.count());
			awake += manager.get_statistics().awake;
			entries += manager.get_statistics().list_entries;
		}
	}
	std::sort(times.begin(), times.end());
	const TileStatistics &statistics = manager.get_statistics();
	std::printf("%d,%d,%zu,%.0f,%.0f,%llu,%llu,%llu,%.1f,%.1f,%.1f,%zu\n", manager.get_grid().get_tile_count(), p_count,
			r_other.size() * sizeof(uint64_t) >> 20, awake / STEPS, entries / STEPS, static_cast<unsigned long long>(statistics.woken),
			static_cast<unsigned long long>(statistics.evicted), static_cast<unsigned long long>(statistics.refused), times.front(),
			times[STEPS / 2], times[STEPS * 99 / 100], manager.get_memory_usage());
}

} // namespace

// With two arguments, metres and objects: only that, for a profiler.
int main(int p_count, char **p_arguments) {
	std::puts("tiles,objects,other_mib,awake_tiles,list_entries,woken,evicted,refused,update_us_min,update_us_median,update_us_p99,memory_"
			  "bytes");
	if (p_count == 3) {
		std::vector<uint64_t> none;
		run(std::atof(p_arguments[1]), std::atoi(p_arguments[2]), none);
		return 0;
	}
	for (const size_t other : { size_t(0), OTHER_MEMORY }) {
		std::vector<uint64_t> memory(other / sizeof(uint64_t));
		for (const double size : { 70.5, 500.0, 2000.0 }) { // 20,000, 1,000,000 and 16,000,000 tiles
			for (const int count : { 0, 128, 1024, 5000 }) {
				run(size, count, memory);
			}
		}
	}
	return 0;
}
