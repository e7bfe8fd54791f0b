// SPDX-License-Identifier: MIT
// Blades that something rests on: they stand still, every one of them, and rise when it leaves.
#include <doctest/doctest.h>

#include "blade_scene.h"
#include "sampled.h"

#include "core/solver/edge.h"

#include <Eigen/Geometry>

#include <array>
#include <string>

using namespace grass;
using namespace grass::test;

namespace {

// A shape that comes down on the blades and stays.
struct Rest {
	int shape;
	Eigen::Vector3f size; // metres
	float height, aside; // of its centre where it stays, and of that from the roots, metres
	Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
	bool is_cut = false; // a hull without corners
};

class Numbers {
public:
	explicit Numbers(unsigned p_seed) : _random(p_seed) {}
	float between(float p_low, float p_high) { return std::uniform_real_distribution<float>(p_low, p_high)(_random); }

private:
	std::mt19937 _random;
};

std::vector<Rest> make_rests() {
	const Eigen::Vector3f plate(0.5f, 0.1f, 0.5f);
	std::vector<Rest> rests = { { GRASS_BOX, plate, 0.18f, 0.0f }, { GRASS_BOX, plate, 0.35f, 0.0f },
		{ GRASS_CYLINDER, plate, 0.18f, 0.0f }, { GRASS_HULL, plate, 0.18f, 0.0f }, { GRASS_SPHERE, { 0.15f, 0.0f, 0.0f }, 0.15f, 0.1f },
		{ GRASS_SPHERE, { 0.3f, 0.0f, 0.0f }, 0.4f, 0.1f }, { GRASS_CAPSULE, { 0.1f, 0.2f, 0.0f }, 0.32f, 0.1f } };
	Numbers numbers(7);
	for (int i = 0; i < 15; i++) {
		const float x = numbers.between(0.08f, 0.25f), y = numbers.between(0.06f, 0.2f), z = numbers.between(0.08f, 0.25f);
		const int shape = SHAPES[i % 5];
		const float half = shape == GRASS_SPHERE ? x : shape == GRASS_CAPSULE ? x + y : y;
		const float above = i % 3 == 0 ? 0.0f : numbers.between(0.0f, 0.3f);
		rests.push_back({ shape, { x, y, z }, half + above, numbers.between(-0.3f, 0.3f) });
	}
	return rests;
}

// How high the centre of a shape is that stands on the ground.
float half_height(const Rest &p_rest) {
	const Eigen::Vector3f up = (p_rest.turn.conjugate() * Eigen::Vector3f::UnitY()).cwiseAbs();
	switch (p_rest.shape) {
		case GRASS_SPHERE:
			return p_rest.size.x();
		case GRASS_CAPSULE:
			return p_rest.size.x() + up.y() * p_rest.size.y();
		case GRASS_CYLINDER:
			return up.y() * p_rest.size.y() + std::sqrt(std::max(1.0f - up.y() * up.y(), 0.0f)) * p_rest.size.x();
		default:
			return up.dot(p_rest.size);
	}
}

// Small, middling and large ones that stand on the ground or hang above it, level and tilted.
struct Kind {
	const char *name;
	int shape;
	float least_tilt, most_tilt; // radians from upright
	bool is_cut;
};
constexpr Kind KINDS[] = { { "ball", GRASS_SPHERE, 0.0f, 0.0f, false }, { "box, flat", GRASS_BOX, 0.0f, 0.0f, false },
	{ "box, tilted", GRASS_BOX, 0.1f, 1.4f, false }, { "capsule, upright", GRASS_CAPSULE, 0.0f, 0.0f, false },
	{ "capsule, lying", GRASS_CAPSULE, 1.0f, 1.57f, false }, { "cylinder, upright", GRASS_CYLINDER, 0.0f, 0.0f, false },
	{ "cylinder, tilted", GRASS_CYLINDER, 0.1f, 1.57f, false }, { "hull, tilted", GRASS_HULL, 0.1f, 1.4f, false },
	{ "hull without corners, tilted", GRASS_HULL, 0.1f, 1.4f, true } };

std::vector<Rest> make_rests(const Kind &p_kind, int p_count, unsigned p_seed) {
	Numbers numbers(p_seed);
	std::vector<Rest> rests;
	for (int i = 0; i < p_count; i++) {
		const float scale = i % 4 == 3 ? 2.0f : i % 4 == 2 ? 0.4f : 1.0f;
		const float x = numbers.between(0.08f, 0.25f), y = numbers.between(0.06f, 0.2f), z = numbers.between(0.08f, 0.25f);
		const float yaw = numbers.between(-3.14f, 3.14f), tilt = numbers.between(p_kind.least_tilt, p_kind.most_tilt);
		const float heading = numbers.between(-3.14f, 3.14f);
		Rest rest{ p_kind.shape, Eigen::Vector3f(x, y, z) * scale, 0.0f, numbers.between(-0.3f, 0.3f), Eigen::Quaternionf::Identity(),
			p_kind.is_cut };
		rest.turn = Eigen::AngleAxisf(tilt, Eigen::Vector3f(std::cos(heading), 0.0f, std::sin(heading))) *
				Eigen::AngleAxisf(yaw, Eigen::Vector3f::UnitY());
		rest.height = half_height(rest) + (i % 3 == 0 ? 0.0f : numbers.between(0.0f, 0.3f));
		rests.push_back(rest);
	}
	return rests;
}

constexpr float ACROSS = 0.013f; // of the bodies from the roots, metres

// Moves the scene's first collider, p_rest, straight from one height to another, metres, in p_steps steps.
void move(BladeScene &r_scene, const Rest &p_rest, float p_from, float p_to, int p_steps, float p_rate) {
	for (int i = 0; i < p_steps; i++) {
		const float before = p_from + (p_to - p_from) * float(i) / float(p_steps);
		const float now = p_from + (p_to - p_from) * float(i + 1) / float(p_steps);
		BladeScene::place(r_scene.colliders[0], { p_rest.aside, before, ACROSS }, { p_rest.aside, now, ACROSS });
		r_scene.step(1.0 / p_rate);
	}
	BladeScene::place(r_scene.colliders[0], { p_rest.aside, p_to, ACROSS }, { p_rest.aside, p_to, ACROSS });
}

// Two seconds after the shape came to rest, at p_rate steps a second.
BladeScene make_held(const Rest &p_rest, float p_rate, const SolverParams &p_params = {}) {
	constexpr float SPEED = 0.6f; // m/s
	const float start = std::max(0.9f, p_rest.height + 0.55f); // metres, above all blades
	BladeScene scene;
	scene.params = p_params;
	GrassCollider &collider = scene.add(p_rest.shape, { p_rest.aside, start, ACROSS }, p_rest.size);
	collider.rotation = collider.rotation_before = { p_rest.turn.x(), p_rest.turn.y(), p_rest.turn.z(), p_rest.turn.w() };
	if (p_rest.is_cut) {
		for (int i = 0; i < 8; i++) {
			const Eigen::Vector3f corner(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
			const Eigen::Vector3f normal = corner.normalized();
			scene.planes.push_back({ normal.x(), normal.y(), normal.z(), 0.8f * normal.cwiseAbs().dot(p_rest.size) });
		}
		collider.position_before.w = float(scene.planes.size());
	}
	move(scene, p_rest, start, p_rest.height, int(std::ceil((start - p_rest.height) * p_rate / SPEED)), p_rate);
	scene.step_for(2.0, p_rate);
	return scene;
}

// Whether the shape holds the blade: it is at the surface, and its clamp, which could not get out, is outside.
bool is_held(const BladeScene &p_scene, int p_blade) {
	constexpr float AT = 0.004f; // metres, the solver's skin
	const TileCollider collider = p_scene.tile_colliders()[0];
	const Vec3<float> root = Vec3<float>{} - collider.centre;
	const Eigen::Vector3f clamp = p_scene.knot(p_blade, 1);
	const Edge<float> edge = find_edge(collider, turned(inverse_of(collider.turn), root),
			turned(inverse_of(collider.turn), root + Vec3<float>{ clamp.x(), clamp.y(), clamp.z() }), 1.0f);
	float deepest = -1.0f;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		deepest = std::max(deepest, p_scene.depth_in(collider, p_blade, k));
	}
	return edge.face.distance > 0.0f && deepest > -AT;
}

struct Count {
	int held = 0, moving = 0; // of those, farther than 1e-5 of their length in a step
};

// Watches each blade for a second.
Count count_moving(BladeScene &r_scene, float p_rate) {
	std::array<float, GRASS_BLADES_PER_TILE> most{}; // moved in one step, blade lengths
	BladeScene before;
	for (int i = 0; i < int(p_rate); i++) {
		*before.tile = *r_scene.tile;
		r_scene.step(1.0 / p_rate);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				most[b] = std::max(most[b], (r_scene.knot(b, k) - before.knot(b, k)).norm() / r_scene.length);
			}
		}
	}
	Count count;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		if (is_held(r_scene, b)) {
			count.held++;
			count.moving += most[b] > 1e-5f ? 1 : 0;
		}
	}
	return count;
}

Count count_moving(const std::vector<Rest> &p_rests, float p_rate, const SolverParams &p_params = {}) {
	Count all;
	for (const Rest &rest : p_rests) {
		BladeScene scene = make_held(rest, p_rate, p_params);
		const Count count = count_moving(scene, p_rate);
		all.held += count.held;
		all.moving += count.moving;
	}
	return all;
}

} // namespace

TEST_CASE("METHOD_DIRECT: two seconds after a body came to rest on them one in 500 blades that it holds moves more than 1e-5 L a step") {
	for (const float rate : { 30.0f, 60.0f, 144.0f }) {
		CAPTURE(rate);
		const Count count = count_moving(make_rests(), rate);
		CHECK(count.held > 600);
		CHECK(count.moving <= count.held / 500);
		MESSAGE(rate << " steps a second: " << count.moving << " of " << count.held << " move");
	}
}

TEST_CASE("METHOD_DIRECT: nor do two in a thousand under balls, boxes, capsules, cylinders and hulls of any size, flat and tilted") {
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		CAPTURE(rate);
		Count all;
		for (const Kind &kind : KINDS) {
			const Count count = count_moving(make_rests(kind, 8, 11), rate);
			CAPTURE(kind.name);
			CHECK(count.held > 50);
			all.held += count.held;
			all.moving += count.moving;
			MESSAGE(std::string(kind.name) << ", " << rate << " steps a second: " << count.moving << " of " << count.held << " move");
		}
		CHECK(all.moving <= all.held / 500);
	}
}

TEST_CASE("METHOD_DIRECT: of stiff blades one in a hundred moves, of soft and slippery ones, which slide on for seconds, two, and of tall "
		  "dry ones three") {
	struct Grass {
		std::string name;
		double frequency, damping, friction; // Hz, -, times the body's
		int most; // that move, of a hundred
	};
	for (const Grass &grass :
			{ Grass{ "lawn", 4.0, 0.8, 1.0, 1 }, Grass{ "reed", 0.8, 0.15, 0.5, 2 }, Grass{ "tall dry grass", 0.7, 0.9, 1.5, 3 } }) {
		SolverParams params;
		params.natural_frequency = grass.frequency;
		params.damping_ratio = grass.damping;
		params.friction = grass.friction;
		for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
			const Count count = count_moving(make_rests(), rate, params);
			CAPTURE(grass.name);
			CAPTURE(rate);
			CHECK(count.held > 500);
			CHECK(count.moving * 100 <= count.held * grass.most);
			MESSAGE(grass.name << ", " << rate << " steps a second: " << count.moving << " of " << count.held << " move");
		}
	}
}

TEST_CASE("METHOD_DIRECT: a body that has rested on blades and then moves as slowly as 0.1 mm/s takes as many along as at 1 cm/s, up and "
		  "down") {
	constexpr float WAY = 0.006f, RATE = 30.0f; // metres; more than a touch is deep
	for (const float sign : { -1.0f, 1.0f }) {
		CAPTURE(sign);
		int left_quickly = 0;
		for (const float speed : sampled({ 1e-2f, 1e-3f, 1e-4f }, 2)) { // m/s
			int held = 0, left = 0;
			for (const Rest &rest : make_rests()) {
				if (sign < 0.0f && rest.height < half_height(rest) + 0.02f) {
					continue; // it stands on the ground
				}
				BladeScene scene = make_held(rest, RATE);
				std::vector<int> blades;
				for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
					if (is_held(scene, b)) {
						blades.push_back(b);
					}
				}
				move(scene, rest, rest.height, rest.height + sign * WAY, int(std::lround(WAY / speed * RATE)), RATE);
				for (const int b : blades) {
					held++;
					left += is_held(scene, b) ? 0 : 1;
				}
				CHECK(scene.depth() < 1e-5f);
			}
			left_quickly = speed > 5e-3f ? left : left_quickly;
			CAPTURE(speed);
			CHECK(held > 400);
			CHECK(left < held / 10);
			CHECK(left <= left_quickly + held / 100);
			MESSAGE(speed << " m/s " << std::string(sign < 0.0f ? "down: " : "up: ") << left << " of " << held << " left");
		}
	}
}

TEST_CASE("METHOD_DIRECT: what a plate pressed onto a stone that stands still rises when the plate is gone at once, 99 of 100 as high as "
		  "over a stone "
		  "that trembles and so holds nothing") {
	constexpr float RADIUS = 0.045f, HIGH = 0.9f, LOW = 0.15f; // of the stone and of the plate's centre, metres
	constexpr float TREMBLE = 1e-6f; // metres
	int pressed = 0, hanging = 0; // and its tip more than 5 cm from where it would be
	for (const float aside : { 0.06f, 0.08f, 0.1f, 0.15f, 0.2f, 0.3f }) {
		float heights[2][GRASS_BLADES_PER_TILE] = {}; // of the tips, metres
		for (const bool trembles : { false, true }) {
			BladeScene scene;
			const Rest plate{ GRASS_BOX, { 0.5f, 0.05f, 0.5f }, LOW, 0.0f };
			scene.add(plate.shape, { 0.0f, HIGH, ACROSS }, plate.size);
			scene.add(GRASS_SPHERE, { aside, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
			move(scene, plate, HIGH, LOW, 75, 60.0f);
			scene.step_for(2.0);
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				pressed += trembles && scene.knot(b, GRASS_KNOTS - 1).y() < LOW ? 1 : 0;
			}
			scene.colliders.erase(scene.colliders.begin());
			for (int i = 0; i < 240; i++) {
				const float now = trembles && i % 2 == 0 ? TREMBLE : 0.0f, before = trembles ? TREMBLE - now : 0.0f;
				BladeScene::place(scene.colliders[0], { aside + before, RADIUS, 0.0f }, { aside + now, RADIUS, 0.0f });
				scene.step();
			}
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				heights[trembles ? 1 : 0][b] = scene.knot(b, GRASS_KNOTS - 1).y();
			}
		}
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			hanging += std::abs(heights[0][b] - heights[1][b]) > 0.05f ? 1 : 0;
		}
	}
	MESSAGE(hanging << " of " << pressed << " hang");
	CHECK(pressed > 300);
	CHECK(hanging * 100 <= pressed);
}

TEST_CASE("METHOD_DIRECT: what a body held rises when it leaves, and is at rest four seconds later") {
	for (const Rest &rest : make_rests()) {
		CAPTURE(rest.shape);
		CAPTURE(rest.height);
		BladeScene scene = make_held(rest, 60.0f);
		scene.colliders.clear();
		scene.step_for(4.0);
		CHECK(scene.distance_from_rest() < 1e-3f);
	}
}

TEST_CASE("METHOD_DIRECT: a blade that is folded at its root and lies on the ground, away from where it leans, rises at once") {
	BladeScene scene;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float side = 0.2f + 0.2f * float(b) / float(GRASS_BLADES_PER_TILE); // of the fold, shares of a segment
		const Eigen::Vector3f tip = scene.rest(b, GRASS_KNOTS - 1);
		const Eigen::Vector3f lean = Eigen::Vector3f(tip.x() + 1e-4f, 0.0f, tip.z()).normalized();
		Eigen::Vector3f knot = scene.rest(b, 1);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f down = lean * side - Eigen::Vector3f::UnitY() * std::sqrt(1.0f - side * side);
			const Eigen::Vector3f along = (Eigen::Vector3f::UnitY() * 0.02f * float(k - 2) - lean).normalized();
			knot += (k == GRASS_CLAMPED_KNOTS ? down : along) * (scene.length / GRASS_SEGMENTS);
			scene.set_knot(b, k, knot);
		}
	}
	scene.step_for(4.0);
	CHECK(scene.distance_from_rest() < 0.01f);
}
