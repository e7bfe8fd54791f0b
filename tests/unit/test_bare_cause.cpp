// SPDX-License-Identifier: MIT
// Why a place is bare: the one that leaves the least is named.
#include "core/field/bare_cause.h"
#include "core/paint/brush.h"
#include "fill_scene.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double TALL = 0.5; // metres, of the grass

BareCause cause_at(const PaintMap &p_map, const FillRule *p_rule, const FillSources &p_sources, double p_x, double p_z) {
	return find_bare_cause(p_map, p_rule, p_sources, { p_x, p_z }, TALL);
}

} // namespace

TEST_CASE("bare cause: each condition of a rule is named where it leaves the least, and all together are what fill() writes") {
	const FillRule rule = rule_of({ { FILL_DENSITY, 0.9 }, { FILL_SLOPE_MAX, 30.0 }, { FILL_HEIGHT_MAX, 8.0 }, { FILL_HEIGHT_FADE, 1.0 },
			{ FILL_NOISE_COVER, 0.6 }, { FILL_NOISE_SIZE, 6.0 } });
	FillObstacle box = FillObstacle::solid(shape_of(GRASS_BOX, { 3.0, 9.0, 3.0 }), pose_of({ -40.0, 0.0, 40.0 }), 1.0);
	box.set_clearance(0.0, 2.0);
	FillObstacle hedge = FillObstacle::line({ { -60.0, 60.0 }, { 60.0, 20.0 } });
	hedge.set_clearance(0.5, 2.0);
	hedge.set_planting(true);
	const FillSources sources = sources_of({ hedge, box });
	PaintMap map;
	lay(map, [](const Eigen::Vector2d &p_at) { return p_at.x() > 20.0 ? p_at.x() - 20.0 : (p_at.y() < -40.0 ? 10.0 : 0.0); });
	fill_all(map, rule, sources);
	int seen[int(FillCondition::OBSTACLE) + 1] = {};
	for (int j = -120; j < 120; j += 3) {
		for (int i = -120; i < 120; i += 3) {
			const Eigen::Vector2d at(0.5 * i + 0.1, 0.5 * j + 0.3);
			const FillCause cause = find_fill_cause(map, rule, sources, at);
			CHECK(info_of(MAP_DENSITY).code(cause.density) == map.get_code(MAP_DENSITY, 0, i, j));
			CHECK(cause.share >= cause.density);
			CHECK((cause.condition == FillCondition::OBSTACLE) == (cause.obstacle != nullptr));
			seen[int(cause.condition)]++;
		}
	}
	for (const FillCondition condition :
			{ FillCondition::DENSITY, FillCondition::SLOPE, FillCondition::HEIGHT, FillCondition::NOISE, FillCondition::OBSTACLE }) {
		INFO("condition ", int(condition));
		CHECK(seen[int(condition)] > 0);
	}
	const FillCause slope = find_fill_cause(map, rule, {}, { 24.0, 0.0 });
	CHECK(slope.condition == FillCondition::SLOPE);
	CHECK(slope.value == doctest::Approx(45.0).epsilon(0.02));
	const BareCause inside = cause_at(map, &rule, sources, -40.0, 40.0);
	CHECK(inside.kind == BareKind::RULE);
	CHECK(inside.rule.obstacle == sources.obstacles[1]);
}

TEST_CASE("bare cause: a hand, wear, a low height and a cut are told apart from a rule") {
	const FillRule rule = rule_of({ { FILL_DENSITY, 1.0 } });
	PaintMap map;
	CHECK(cause_at(map, nullptr, {}, 0.0, 0.0).kind == BareKind::MAP); // nothing grows anywhere
	fill_all(map, rule);
	CHECK(cause_at(map, &rule, {}, 0.0, 0.0).kind == BareKind::GRASS);
	const auto set = [&](MapChannel p_channel, int p_component, int p_i, int32_t p_code) {
		map.set_code(p_channel, p_component, p_i, 0, p_code);
		map.set_code(p_channel, p_component, p_i, 1, p_code);
		map.set_code(p_channel, p_component, p_i + 1, 0, p_code);
		map.set_code(p_channel, p_component, p_i + 1, 1, p_code);
	};
	set(MAP_PAINT, 1, 20, 255); // a hand erased
	set(MAP_DENSITY, 0, 20, 0);
	CHECK(cause_at(map, &rule, {}, 10.5, 0.5).kind == BareKind::PAINTED);
	set(MAP_WEAR, 0, 30, 255);
	CHECK(cause_at(map, &rule, {}, 15.5, 0.5).kind == BareKind::WORN);
	set(MAP_WEAR, 0, 40, 128);
	CHECK(cause_at(map, &rule, {}, 20.5, 0.5).share == doctest::Approx(0.75).epsilon(0.01)); // half worn, as the drawing thins it out
	set(MAP_HEIGHT, 0, 25, 25);
	CHECK(cause_at(map, &rule, {}, 26.0, 1.0).kind == BareKind::SHORT);
	set(MAP_CUT, 0, 80, 5);
	const BareCause cut = cause_at(map, &rule, {}, 40.5, 0.5);
	CHECK(cut.kind == BareKind::CUT);
	CHECK(cut.value == doctest::Approx(0.05));
	CHECK(cut.share == doctest::Approx(0.1));
	set(MAP_DENSITY, 0, 100, 0); // neither a hand nor the rule
	CHECK(cause_at(map, &rule, {}, 50.5, 0.5).kind == BareKind::MAP);
	set(MAP_DENSITY, 0, 110, 235); // nearly what the rule writes, but not a blend with neighbours
	CHECK(cause_at(map, &rule, {}, 55.5, 0.5).kind == BareKind::MAP);
	set(MAP_DENSITY, 0, 120, 252);
	CHECK(cause_at(map, &rule, {}, 60.5, 0.5).kind == BareKind::RULE);
	FillRule at_obstacles = rule; // and leaves all other places as they are
	at_obstacles.only_at_obstacles = true;
	CHECK(cause_at(map, &at_obstacles, {}, 60.5, 0.5).kind == BareKind::MAP);
}
