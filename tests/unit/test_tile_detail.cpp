// SPDX-License-Identifier: MIT
// How many blades of a tile are simulated, and those that join them.
#include "core/lod/tile_detail.h"

#include "pool_scene.h"

#include "core/lod/cull.h"
#include "core/solver/join.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <random>
#include <utility>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int ALL = GRASS_BLADES_PER_TILE;

// 60 m a side, tiles of half a metre.
CullField make_field() {
	return { TileGrid::make(60.0, 60.0, 256.0), 0.25f, 0.5f, { 0.015f, 0.5f }, 7, { 65536, 65536 } };
}

// Turned about the vertical axis, 75 degrees high and wide. p_pixels: height of its picture.
ViewCamera make_camera(const Eigen::Vector3f &p_eye, float p_turn, float p_pixels = 1080.0f) {
	ViewCamera camera;
	const float half = 0.6545f, s = std::sin(half), c = std::cos(half);
	const Eigen::AngleAxisf turn(p_turn, Eigen::Vector3f::UnitY());
	const Eigen::Vector3f normals[] = { { 0, 0, 1 }, { 0, 0, -1 }, { c, 0, s }, { -c, 0, s }, { 0, c, s }, { 0, -c, s } };
	const float distances[] = { -0.05f, 200.0f, 0, 0, 0, 0 };
	for (size_t i = 0; i < 6; i++) {
		const Eigen::Vector3f normal = turn * normals[i];
		camera.planes[i] << normal, normal.dot(p_eye) + distances[i];
	}
	camera.eye = p_eye;
	camera.pixel_slope = 2.0f * std::tan(half) / p_pixels;
	return camera;
}

FieldView view_from(const Eigen::Vector3f &p_eye, float p_turn = 0.0f, float p_pixels = 1080.0f) {
	FieldView view;
	view.is_watched = true;
	view.cameras = { make_camera(p_eye, p_turn, p_pixels) };
	view.shadow_distance = 60.0f;
	view.shadow_margin = 2.0f;
	view.falls = { { 1.0f, -0.5f, 0.3f } };
	return view;
}

// Returns how many of the tiles that are drawn, or cast shadows, draw a blade that p_detail leaves out. r_tiles: all of them.
int count_missing(const TileDetail &p_detail, const FieldView &p_view, int &r_tiles) {
	static TileCull cull;
	const CullField field = make_field();
	cull.choose(field, p_view, nullptr, [](int) { return GRASS_NO_SLOT; });
	int missing = 0;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const std::span<const float> all = cull.get_instances(level);
		for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
			const int x = int(all[at + INSTANCE_TILE]), z = int(all[at + INSTANCE_TILE + 1]);
			missing += all[at + INSTANCE_BLADES] > float(p_detail.blades_of(x, z, 0));
			r_tiles++;
		}
	}
	return missing;
}

Eigen::Vector3f offset_of(const PoolScene &p_scene, int p_blade, int p_knot) {
	return p_scene.pool.get_knots(0, p_blade)[size_t(p_knot)] - p_scene.rest(0, p_blade, p_knot);
}

// Leaves out p_count of the blades of the scene's first tile.
void leave_out(PoolScene &r_scene, int p_count) {
	vec4 &blend = r_scene.slots[0].blend;
	blend = { 0.0f, float(p_count), blend.y, blend.y };
}

} // namespace

TEST_CASE("tile detail: every blade that is drawn is simulated, until an eye has moved by the slack") {
	std::mt19937 random(20261126);
	std::uniform_real_distribution<float> share(-1.0f, 1.0f);
	int tiles = 0;
	for (int i = 0; i < 24; i++) {
		const Eigen::Vector3f eye(30.0f * share(random), 3.2f + 2.9f * share(random), 30.0f * share(random));
		const float turn = 3.14f * share(random), pixels = i % 2 == 0 ? 1080.0f : 2160.0f;
		TileDetail detail;
		REQUIRE(detail.see(make_field(), view_from(eye, turn, pixels), nullptr));
		CHECK(count_missing(detail, view_from(eye, turn, pixels), tiles) == 0);
		const Eigen::Vector3f way = Eigen::Vector3f(share(random), share(random), share(random)).normalized() * (0.99f * TileDetail::SLACK);
		const FieldView moved = view_from(eye + way, 3.14f * share(random), pixels);
		CHECK_FALSE(detail.see(make_field(), moved, nullptr));
		CHECK(count_missing(detail, moved, tiles) == 0);
	}
	CHECK(tiles > 50000);
}

TEST_CASE("tile detail: far tiles simulate an eighth or less, whether or not the camera looks there") {
	TileDetail detail;
	CHECK(detail.blades_of(60, 60, 0) == ALL); // nobody has looked yet
	REQUIRE(detail.see(make_field(), view_from({ 0.0f, 1.7f, 0.0f }), nullptr));
	CHECK(detail.blades_of(60, 60, 0) >= 56); // the tile under the eye
	for (const int z : { 2, 117 }) { // ahead and behind
		CHECK(detail.blades_of(60, z, 0) <= ALL / 8);
	}
	int last = ALL;
	for (int z = 60; z >= 0; z--) {
		const int blades = detail.blades_of(60, z, 0);
		CHECK(blades <= last + GRASS_DETAIL_BLADES); // fades begin at another distance in each tile
		CHECK(blades % GRASS_DETAIL_BLADES == 0);
		last = std::min(last, blades);
	}
	CHECK(detail.see(make_field(), FieldView(), nullptr)); // no camera
	CHECK(detail.blades_of(60, 2, 0) == ALL);
}

TEST_CASE("tile detail: an eye that goes to and fro changes no tile") {
	TileDetail detail;
	std::vector<int> blades(120, 0);
	int changes = 0;
	for (int round = 0; round < 20; round++) {
		detail.see(make_field(), view_from({ 0.0f, 1.7f, round % 2 == 0 ? 0.0f : 0.3f }), nullptr);
		for (int z = 0; z < 120; z++) {
			const int before = std::exchange(blades[size_t(z)], detail.blades_of(60, z, blades[size_t(z)]));
			changes += round > 1 && blades[size_t(z)] != before;
		}
	}
	CHECK(changes == 0);
}

TEST_CASE("tile detail: a tile whose blades are read is whole for a second") {
	TileDetail detail;
	const CullField field = make_field();
	const FieldView view = view_from({ 0.0f, 1.7f, 0.0f });
	detail.see(field, view, nullptr);
	const int few = detail.blades_of(60, 2, 0);
	CHECK(few <= ALL / 8);
	const int tile = field.grid.get_index(60, 2);
	CHECK(detail.ask(tile));
	CHECK_FALSE(detail.ask(tile)); // again
	CHECK(detail.blades_of(60, 2, 0) == ALL);
	for (int frame = 1; frame < TileDetail::FRAMES_ASKED; frame++) {
		CHECK_FALSE(detail.see(field, view, nullptr));
	}
	CHECK(detail.blades_of(60, 2, 0) == ALL);
	CHECK(detail.see(field, view, nullptr));
	CHECK(detail.blades_of(60, 2, 0) == few);
}

TEST_CASE("left out blades: the simulated ones move as before, bit for bit; the others stay") {
	PoolScene whole(1), thinned(1);
	for (int i = 0; i < 30; i++) {
		leave_out(thinned, i == 0 ? 0 : 48);
		whole.step();
		thinned.step();
	}
	CHECK(thinned.pool.get_simulated_blades() == 64 + 29 * 16);
	int moved = 0;
	for (int blade = 0; blade < ALL; blade++) {
		const bool same = whole.pool.get_knots(0, blade) == thinned.pool.get_knots(0, blade);
		CHECK((same || blade >= 16));
		moved += !same;
	}
	CHECK(moved > 20);
}

TEST_CASE("left out blades: whole groups of lanes are left out, so that all machines do the same") {
	for (const auto &[wanted, simulated] : { std::pair(0, 64), { 8, 64 }, { 16, 48 }, { 40, 32 }, { 56, 16 }, { 99, 16 }, { -5, 64 } }) {
		PoolScene scene(1);
		leave_out(scene, wanted);
		scene.step();
		CHECK(scene.pool.get_simulated_blades() == simulated);
	}
}

TEST_CASE("[Eq 49] blades that join have their neighbour's pose and speed, and their own length") {
	PoolScene scene(1);
	for (int i = 0; i < 14; i++) { // the ball is among them
		leave_out(scene, i == 0 ? 0 : 48);
		scene.step();
	}
	leave_out(scene, 0);
	scene.slots[0].blend.x = 1.0f;
	scene.pool.join(scene.slots[0]);
	int bent = 0, alike = 0;
	for (int blade = 16; blade < ALL; blade++) {
		const std::vector<Eigen::Vector3f> knots = scene.pool.get_knots(0, blade);
		double nearest = 1e9;
		int neighbour = 0;
		for (int other = 0; other < 16; other++) {
			const auto root = [&](int p_blade) {
				const uint16_t *halves = &shared_patch()->texels[Patch::texel_index(int(scene.slots[0].list.x) + p_blade, 0)];
				return Eigen::Vector2d(half_to_float(halves[0]), half_to_float(halves[1]));
			};
			const double away = (root(blade) - root(other)).norm();
			neighbour = away < nearest ? other : neighbour;
			nearest = std::min(nearest, away);
		}
		float length = 0.0f, rest_length = 0.0f, other_length = 0.0f;
		for (int k = 1; k < GRASS_KNOTS; k++) {
			length += (knots[size_t(k)] - knots[size_t(k - 1)]).norm();
			rest_length += (scene.rest(0, blade, k) - scene.rest(0, blade, k - 1)).norm();
			other_length += (scene.rest(0, neighbour, k) - scene.rest(0, neighbour, k - 1)).norm();
		}
		CHECK(length == doctest::Approx(rest_length).epsilon(1e-4));
		const int tip = GRASS_KNOTS - 1;
		const Eigen::Vector3f own = offset_of(scene, blade, tip) / rest_length, its = offset_of(scene, neighbour, tip) / other_length;
		alike += (own - its).norm() < 0.25f; // lengths are kept, so that shapes at rest which differ make poses that do
		CHECK((own.norm() > 0.0f) == (its.norm() > 0.0f)); // at rest beside one at rest, bit for bit
		bent += own.norm() > 0.1f;
	}
	CHECK(alike > 36); // of 48
	CHECK(bent > 4);
	const Eigen::Vector3f before = scene.pool.get_knots(0, 40)[GRASS_KNOTS - 1];
	scene.step();
	CHECK(scene.pool.get_knots(0, 40)[GRASS_KNOTS - 1].allFinite());
	CHECK((scene.pool.get_knots(0, 40)[GRASS_KNOTS - 1] - before).norm() < 0.1f);
}

TEST_CASE("[Eq 49] a blade that joins moves as many times as far in a step as it is longer than its neighbour") {
	auto state = std::make_unique<TileState>(); // all at the same root
	for (int k = 0; k < GRASS_KNOTS; k++) {
		state->rest[1][k][0] = 0.02f * float(k);
		state->rest[1][k][1] = 0.05f * float(k);
	}
	for (int free = 0; free < GRASS_FREE_KNOTS; free++) {
		state->knots[1][free][0] = state->before[1][free][0] = state->rest[1][free + GRASS_CLAMPED_KNOTS][0];
		state->knots[0][free][0] = 0.004f * float(free);
		state->before[0][free][0] = 0.003f * float(free);
	}
	join_blades(*state, { 1, 1, 2 });
	for (int free = 0; free < GRASS_FREE_KNOTS; free++) {
		CHECK(state->knots[0][free][1] - state->before[0][free][1] == doctest::Approx(2.5 * 0.001 * free).epsilon(1e-3));
	}
}

TEST_CASE("contact_distance: contact is finer where an eye is near, and as at its least elsewhere, bit for bit") {
	PoolScene plain(1), near(1), far(1);
	plain.params.contact_rate = CONTACT_RATE.minimum;
	near.params.contact_rate = far.params.contact_rate = 3200.0;
	far.slots[0].list.w |= GRASS_SLOT_FAR;
	int differing = 0;
	for (int i = 0; i < 20; i++) {
		for (PoolScene *scene : { &plain, &near, &far }) {
			scene->step();
		}
	}
	for (int blade = 0; blade < ALL; blade++) {
		CHECK(far.pool.get_knots(0, blade) == plain.pool.get_knots(0, blade));
		differing += near.pool.get_knots(0, blade) != plain.pool.get_knots(0, blade);
	}
	CHECK(differing > 20);
	TileDetail detail;
	CHECK(detail.is_within(60, 2, 4.0)); // nobody has looked: everything is simulated whole
	detail.see(make_field(), view_from({ 0.0f, 1.7f, 0.0f }), nullptr);
	CHECK(detail.is_within(60, 60, 4.0));
	CHECK(detail.is_within(60, 67, 4.0));
	CHECK_FALSE(detail.is_within(60, 69, 4.0));
}
