// SPDX-License-Identifier: MIT
#include "core/paint/mow.h"

#include "core/paint/recovery.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace grass;

namespace {

const GrassKind KIND{ 0.4, 0.9, 256.0, {} };

ColliderShape solid(int p_type, const Eigen::Vector3d &p_size, const Eigen::Vector3d &p_place,
		const Eigen::Vector3d &p_turn = Eigen::Vector3d::Zero()) {
	ColliderShape shape;
	shape.type = p_type;
	shape.size = p_size;
	shape.now.position = p_place;
	if (p_turn.norm() > 0.0) {
		shape.now.rotation = Quaternion(Eigen::AngleAxisd(p_turn.norm(), p_turn.normalized()));
	}
	return shape;
}

// Returns a box's faces as a hull.
ColliderShape hull(const Eigen::Vector3d &p_half, const Eigen::Vector3d &p_place) {
	ColliderShape shape = solid(GRASS_HULL, p_half, p_place);
	for (int axis = 0; axis < 3; axis++) {
		for (const float side : { 1.0f, -1.0f }) {
			Eigen::Vector4f plane = Eigen::Vector4f::Zero();
			plane[axis] = side;
			plane.w() = float(p_half[axis]);
			shape.planes.push_back(plane);
		}
	}
	return shape;
}

PaintMap meadow() {
	PaintMap map;
	map.set_base_density(1.0);
	return map;
}

CutResult cut(PaintMap &r_map, const Footprint &p_footprint) {
	return cut_grass(r_map, { &p_footprint }, KIND);
}

MowRegion square(double p_half) {
	return { nullptr, { { -p_half, -p_half }, { p_half, p_half } } };
}

} // namespace

TEST_CASE("footprint: the underside of every shape") {
	const auto low = [](const ColliderShape &p_shape, double p_x, double p_z) { return Footprint(p_shape).get_span({ p_x, p_z })->low; };
	CHECK(low(solid(GRASS_SPHERE, { 2, 0, 0 }, { 1, 5, 0 }), 1.0, 0.0) == doctest::Approx(3.0));
	CHECK(low(solid(GRASS_SPHERE, { 2, 0, 0 }, { 1, 5, 0 }), 2.0, 0.0) == doctest::Approx(5.0 - std::sqrt(3.0)));
	CHECK(low(solid(GRASS_BOX, { 1, 0.5, 2 }, { 0, 1, 0 }), 0.9, 1.9) == doctest::Approx(0.5));
	CHECK(low(hull({ 1, 0.5, 2 }, { 0, 1, 0 }), -0.9, 1.9) == doctest::Approx(0.5));
	CHECK(low(solid(GRASS_CYLINDER, { 1, 0.5, 0 }, { 0, 1, 0 }), 0.0, 0.9) == doctest::Approx(0.5));
	CHECK(low(solid(GRASS_CAPSULE, { 1, 2, 0 }, { 0, 4, 0 }), 0.0, 0.0) == doctest::Approx(1.0));
	const Eigen::Vector3d lying(std::numbers::pi / 2, 0, 0); // along z
	CHECK(low(solid(GRASS_CAPSULE, { 1, 2, 0 }, { 0, 4, 0 }, lying), 0.0, 1.5) == doctest::Approx(3.0));
	CHECK(low(solid(GRASS_CYLINDER, { 1, 2, 0 }, { 0, 4, 0 }, lying), 0.5, 1.9) == doctest::Approx(4.0 - std::sqrt(0.75)));
	const Eigen::Vector3d on_edge(0, 0, std::numbers::pi / 4);
	CHECK(low(solid(GRASS_BOX, { 1, 1, 1 }, { 0, 4, 0 }, on_edge), 0.0, 0.0) == doctest::Approx(4.0 - std::sqrt(2.0)));
	CHECK_FALSE(Footprint(solid(GRASS_SPHERE, { 2, 0, 0 }, { 0, 5, 0 })).get_span({ 1.9, 1.9 }).has_value());
	CHECK_FALSE(Footprint(solid(GRASS_BOX, { 1, 1, 1 }, { std::nan(""), 5, 0 })).get_span({ 0, 0 }).has_value());
	CHECK(Footprint(solid(99, { 1, 1, 1 }, { 0, 0, 0 })).is_empty());
}

TEST_CASE("cut_grass: a deck of 2 m x 1 m at 10 cm leaves 10 cm, and says what fell") {
	PaintMap map = meadow();
	const Footprint deck(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.2, 0 }));
	const CutResult result = cut(map, deck);
	CHECK(result.area == doctest::Approx(2.0));
	CHECK(result.volume == doctest::Approx(2.0 * 0.3));
	CHECK(result.blades == doctest::Approx(512.0));
	CHECK(result.changed.size() == 4);
	CHECK(map.sample(MAP_CUT, 0, { 0.25, 0.25 }) == doctest::Approx(0.1));
	CHECK(map.get_code(MAP_CUT, 0, 2, 0) == map.initial_code(MAP_CUT, 0));
	CHECK(cut(map, deck).area == 0.0);
	CHECK(cut(map, deck).changed.empty());
	CHECK(mown_share(map, square(2.0), KIND) == doctest::Approx(2.0 / 16.0));
	CHECK(mown_share(map, { &deck }, KIND) == 1.0);
}

TEST_CASE("cut_grass: only grass that stands falls, and only above the ground") {
	PaintMap map = meadow();
	const MapShape everywhere = MapShape::stroke({ 0, 0 }, { 0, 0 }, 5.0, 1.0, Falloff::LINEAR);
	Brush brush;
	brush.tool = MapTool::DENSITY;
	brush.target = 0.5;
	apply_brush(map, everywhere, brush);
	CHECK(cut(map, Footprint(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.2, 0 }))).area == doctest::Approx(1.0).epsilon(0.01));
	CHECK(cut(map, Footprint(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 3.0, 2 }))).area == 0.0);
	CHECK(cut(map, Footprint(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, -3.0, 2 }))).area == 0.0);
	const CutResult above = cut(map, Footprint(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.6, 2 })));
	CHECK(above.area == 0.0); // higher than the grass stands on average: only tall blades lose their tips
	brush.tool = MapTool::ERASE;
	apply_brush(map, everywhere, brush);
	CHECK(cut(map, Footprint(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.15, -2 }))).area == 0.0);
	CHECK(mown_share(map, square(1.0), KIND) == 0.0);
}

TEST_CASE("cut_grass and mown_share: a deck over the border acts within it") {
	PaintMap map = meadow();
	const Footprint deck(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 4, 0.2, 0 })); // half of it beyond x = 4
	const MowRegion field{ &deck, square(4.0).rectangle };
	CHECK(cut_grass(map, field, KIND).area == doctest::Approx(1.0));
	CHECK(map.get_code(MAP_CUT, 0, 8, 0) == MAP_UNCUT_CODE);
	CHECK(mown_share(map, field, KIND) == 1.0);
	const Footprint outside(solid(GRASS_BOX, { 0.1, 0.1, 0.1 }, { 4.3, 0.2, 0 }));
	CHECK(cut_grass(map, { &outside, field.rectangle }, KIND).changed.empty());
}

TEST_CASE("cut_grass: what falls of each species is its own height") {
	PaintMap map = meadow();
	GrassKind kind = KIND;
	kind.height_at = [](const Eigen::Vector2d &p_place) { return p_place.x() < 0.0 ? 0.15 : 0.4; };
	const Footprint deck(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.2, 0 })); // 2 m^2, half of each, at 0.1 m
	CHECK(cut_grass(map, { &deck }, kind).volume == doctest::Approx(0.05 + 0.3).epsilon(0.03));
}

TEST_CASE("cut_grass and mown_share: no grass grows in a hole, so none falls there") {
	PaintMap map = meadow();
	map.set_code(MAP_HOLE, 0, 0, 0, 1); // a square metre, half of it below the deck
	const Footprint deck(solid(GRASS_BOX, { 1, 0.1, 0.5 }, { 0, 0.2, 0 }));
	CHECK(cut(map, deck).area == doctest::Approx(1.5));
	CHECK(mown_share(map, square(1.0), KIND) == doctest::Approx(1.5 / 3.0));
}

TEST_CASE("cut_grass: a sword cuts, however thin") {
	PaintMap map = meadow();
	const CutResult result = cut(map, Footprint(solid(GRASS_BOX, { 0.02, 0.02, 0.1 }, { 0.05, 0.2, 0.1 })));
	CHECK(result.area == doctest::Approx(0.25));
	CHECK(map.get_code(MAP_CUT, 0, 0, 0) == 18);
}

TEST_CASE("regrow_grass: grows, heals, forgets cuts that cut nothing, and leaves the rest alone") {
	PaintMap map = meadow();
	cut(map, Footprint(solid(GRASS_BOX, { 2, 0.1, 2 }, { 0, 0.2, 0 })));
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	brush.target = 0.8;
	const MapShape disc = MapShape::stroke({ 0, 0 }, { 0, 0 }, 3.0, 1.0, Falloff::LINEAR);
	apply_brush(map, disc, brush);
	brush.target = 1.0;
	brush.strength = 0.01; // less than a code
	apply_brush(map, disc, brush);
	REQUIRE(map.uses(MAP_WEAR_REST));
	regrow_grass(map, square(1.0), KIND, 0.05, 0.3);
	CHECK(map.get_code(MAP_CUT, 0, 0, 0) == 15);
	CHECK(map.get_code(MAP_CUT, 0, 3, 0) == 10);
	CHECK(map.sample(MAP_WEAR, 0, { 0.25, 0.25 }) == doctest::Approx(0.5).epsilon(0.01));
	CHECK(map.sample(MAP_WEAR, 0, { 2.25, 0.25 }) == doctest::Approx(0.8).epsilon(0.01));
	regrow_grass(map, square(100.0), KIND, 2.0, 5.0);
	map.compact();
	CHECK(map.is_empty());
	CHECK(regrow_grass(map, square(100.0), KIND, std::nan(""), std::nan("")).changed.empty());
}

TEST_CASE("recovery: each species at its own rate, and where they mix, each by its share") {
	PaintMap map = meadow();
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	apply_brush(map, MapShape::stroke({ 4, 10 }, { 60, 10 }, 3.0, 1.0, Falloff::LINEAR), brush);
	Recovery recovery;
	const RecoveryRates rates{ { 0.02, 0.0, 0.1 }, 0.0 }; // a second
	const SharesAt shares = [](const Eigen::Vector2d &p_place) -> std::array<float, GRASS_MAX_SPECIES> {
		const float third = std::clamp(float(p_place.x() - 30.0) / 20.0f, 0.0f, 1.0f); // none up to 30 m, alone from 50 m on
		return { p_place.x() < 15.0 ? 0.0f : 1.0f - third, p_place.x() < 15.0 ? 1.0f : 0.0f, third };
	};
	const auto worn = [&](double p_x) { return map.sample(MAP_WEAR, 0, { p_x, 10.25 }); };
	CHECK(worn(40.25) == 1.0);
	for (int step = 0; step < 300; step++) { // 5 s
		recovery.step(map, square(64.0).rectangle, KIND, rates, 1.0 / 60.0, shares);
	}
	CHECK(worn(10.25) == 1.0);
	CHECK(std::abs(worn(25.25) - 0.9) < 0.01);
	CHECK(std::abs(worn(40.25) - (1.0 - 5.0 * (0.02 + 0.08 * 10.5 / 20.0))) < 0.01);
	CHECK(std::abs(worn(55.25) - 0.5) < 0.01);
	for (int step = 0; step < 300; step++) { // nothing is lost in small steps: not even half a code a step
		recovery.step(map, square(64.0).rectangle, KIND, { { 0.06, 0.06, 0.06 }, 0.0 }, 1.0 / 60.0, shares);
	}
	CHECK(std::abs(worn(10.25) - 0.7) < 0.01);
	CHECK(std::abs(worn(25.25) - 0.6) < 0.01);
	CHECK(std::abs(worn(55.25) - 0.2) < 0.01);
	CHECK(RecoveryRates{}.is_none());
	CHECK_FALSE(RecoveryRates{ { 0.0, 0.1 }, 0.0 }.is_none());
}

TEST_CASE("recovery: species are asked for where grass is trampled only, once a metre, and once a code") {
	PaintMap map = meadow();
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	apply_brush(map, MapShape::stroke({ 10, 10 }, { 10, 10 }, 2.0, 1.0, Falloff::LINEAR), brush);
	int worn = 0, asked = 0; // square metres
	for (int j = 0; j < 128; j += 2) {
		for (int i = 0; i < 128; i += 2) {
			const auto is_worn = [&](int p_i, int p_j) { return map.get_code(MAP_WEAR, 0, i + p_i, j + p_j) > 0; };
			worn += is_worn(0, 0) || is_worn(0, 1) || is_worn(1, 0) || is_worn(1, 1) ? 1 : 0;
		}
	}
	const SharesAt shares = [&](const Eigen::Vector2d &) -> std::array<float, GRASS_MAX_SPECIES> {
		asked++;
		return { 0.5f, 0.5f };
	};
	Recovery recovery;
	const double code = info_of(MAP_WEAR).unit;
	recovery.step(map, square(64.0).rectangle, KIND, { { code, 0.0 }, 0.0 }, 0.25, shares); // the chunk gets known
	recovery.step(map, square(64.0).rectangle, KIND, { { code, 0.0 }, 0.0 }, 0.25, shares); // half a code
	CHECK(asked == 0);
	recovery.step(map, square(64.0).rectangle, KIND, { { code, 0.0 }, 0.0 }, 0.5, shares);
	CHECK(asked == worn);
	CHECK(worn > 8);
}

TEST_CASE("recovery: grass that is trampled once more heals as slowly as the first time") {
	PaintMap map = meadow();
	REQUIRE(map.set_code(MAP_TINT, 0, 1, 1, 5)); // a chunk stays when it has healed
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	const Eigen::Vector2d place(30.0, 10.0);
	const auto trample = [&] { apply_brush(map, MapShape::stroke(place, place, 2.0, 1.0, Falloff::LINEAR), brush); };
	Recovery recovery;
	const auto wait = [&](double p_seconds) {
		for (int step = 0; step < int(p_seconds * 60.0); step++) {
			recovery.step(map, square(64.0).rectangle, KIND, { { 0.5 }, 0.0 }, 1.0 / 60.0);
		}
	};
	trample();
	wait(3.0);
	CHECK(map.sample(MAP_WEAR, 0, place) == 0.0);
	map.compact();
	wait(10.0);
	trample();
	wait(0.1);
	CHECK(map.sample(MAP_WEAR, 0, place) > 0.9);
	wait(3.0);
	CHECK(map.sample(MAP_WEAR, 0, place) == 0.0);
}

TEST_CASE("recovery: time heals at the rate it is told, however many chunks there are, and one chunk a step") {
	PaintMap map = meadow();
	Brush brush;
	brush.tool = MapTool::FLATTEN;
	for (int n = -2; n < 2; n++) {
		const Eigen::Vector2d place(64.0 * n + 30.0, 10.0);
		apply_brush(map, MapShape::stroke(place, place, 2.0, 1.0, Falloff::LINEAR), brush);
	}
	Recovery recovery;
	const MapRegion field{ { -128, -64 }, { 64, 64 } }; // without the fourth chunk
	const RecoveryRates rates{ { 0.1 }, 0.0 };
	for (int step = 0; step < 300; step++) {
		CHECK(recovery.step(map, field, KIND, rates, 1.0 / 60.0).changed.size() <= 1);
	}
	for (int n = -2; n < 1; n++) {
		CHECK(std::abs(map.sample(MAP_WEAR, 0, { 64.0 * n + 30.0, 10.0 }) - 0.5) < 0.02);
	}
	CHECK(map.sample(MAP_WEAR, 0, { 64.0 + 30.0, 10.0 }) == 1.0);
	apply_brush(map, MapShape::stroke({ -10, -10 }, { -10, -10 }, 2.0, 1.0, Falloff::LINEAR), brush);
	for (int step = 0; step < 8; step++) {
		recovery.step(map, field, KIND, rates, 1.0 / 60.0);
	}
	CHECK(map.sample(MAP_WEAR, 0, { -10.0, -10.0 }) > 0.97); // does not pay for the time before it was trampled
	CHECK(recovery.step(map, field, KIND, {}, 1.0).changed.empty());
	CHECK(recovery.step(map, field, KIND, rates, std::nan("")).changed.empty());
}
