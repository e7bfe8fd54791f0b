// SPDX-License-Identifier: MIT
// What a field's making takes on the CPU, piece by piece, as CSV on stdout: the median of some runs, against the number of
// blades. The renderer's own objects are not in it.
#include "core/base/cpu_clock.h"
#include "core/map/map_layers.h"
#include "core/paint/brush.h"
#include "core/solver/simulate.h"
#include "core/tiles/tiles.h"

#include <algorithm>
#include <cstdio>
#include <functional>

using namespace grass;

namespace {

constexpr int RUNS = 9;

double median_ms(const std::function<void()> &p_piece) {
	std::vector<double> times;
	for (int run = 0; run < RUNS; run++) {
		CpuClock clock;
		p_piece();
		times.push_back(clock.lap());
	}
	std::sort(times.begin(), times.end());
	return times[RUNS / 2];
}

// Grass of another height on a square about the middle, its side in metres.
PaintMap paint(double p_side) {
	const double half = 0.5 * p_side;
	const Eigen::Vector2d corners[] = { { -half, -half }, { half, -half }, { half, half }, { -half, half } };
	PaintMap map;
	for (const MapTool tool : { MapTool::PAINT, MapTool::HEIGHT }) {
		Brush brush;
		brush.tool = tool;
		brush.target = 0.7;
		apply_brush(map, MapShape(corners, 0.0), brush);
	}
	return map;
}

void lay_out(const PaintMap &p_map, const TileGrid &p_grid) {
	MapLayers map({ p_grid, 1.0, 0.25f });
	map.update(p_map, map.get_region());
}

} // namespace

int main() {
	std::puts("blades,patch_ms,bounds_ms,other_density_bounds_ms,tiles_ms,pool_ms,bare_map_ms,painted_map_ms");
	const auto patch = std::make_shared<const Patch>(generate_patch(PatchParams()));
	for (const double size : { 32.0, 250.0, 2000.0 }) {
		const TileGrid grid = TileGrid::make(size, size, 256.0), denser = TileGrid::make(size, size, 300.0);
		const auto made = std::make_shared<const TileBounds>(*patch, grid, ClumpParams(), 0);
		const double patch_ms = median_ms([] { generate_patch(PatchParams()); });
		const double bounds_ms = median_ms([&] { TileBounds(*patch, grid, ClumpParams(), 0); });
		const double density_ms = median_ms([&] { TileBounds(*made, denser); });
		TileManager manager;
		const double tiles_ms = median_ms([&] {
			manager.set_grid(grid);
			manager.reset();
		});
		const double pool_ms = median_ms([&] { CpuPool(patch, TileParams().pool_size); });
		const double bare_ms = median_ms([&] { lay_out(PaintMap(), grid); });
		const PaintMap painted = paint(std::min(size, 500.0));
		const double painted_ms = median_ms([&] { lay_out(painted, grid); });
		std::printf("%lld,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f\n", static_cast<long long>(grid.get_tile_count()) * GRASS_BLADES_PER_TILE,
				patch_ms, bounds_ms, density_ms, tiles_ms, pool_ms, bare_ms, painted_ms);
	}
	return 0;
}
