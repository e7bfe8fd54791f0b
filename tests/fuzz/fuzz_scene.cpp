// SPDX-License-Identifier: MIT
#include "fuzz_scene.h"

#include "blade_scene.h"
#include "draw_params.h"

#include <array>
#include <sstream>

namespace grass::test {

namespace {

// Numbers from the bytes; zeros after their end.
class Bytes {
public:
	explicit Bytes(std::span<const uint8_t> p_bytes) : _left(p_bytes) {}
	int byte() {
		if (_left.empty()) {
			return 0;
		}
		const int first = _left.front();
		_left = _left.subspan(1);
		return first;
	}
	int below(int p_count) { return byte() % p_count; }
	double share() { return double(byte() * 256 + byte()) / 65535.0; } // 0 to 1
	double between(double p_low, double p_high) { return p_low + share() * (p_high - p_low); }
	Eigen::Vector3f within(double p_size) {
		const auto part = [&] { return float(between(-p_size, p_size)); };
		const float x = part(), y = part();
		return { x, y, part() };
	}
	// Mostly p_usual, now and then what no user should set.
	double odd(double p_usual) {
		constexpr double ODD[] = { 0.0, -1.0, 1e-42, 1e-6, 1e6, 1e15, 1e29, 1e38, -1e38, INFINITY, -INFINITY, NAN };
		return below(8) == 0 ? ODD[below(std::size(ODD))] : p_usual;
	}

private:
	std::span<const uint8_t> _left;
};

SolverParams read_params(Bytes &r_bytes) {
	const auto draw = [&](const Tunable &p_tunable) { return r_bytes.odd(r_bytes.between(p_tunable.minimum, p_tunable.maximum)); };
	SolverParams params = draw_params(r_bytes.below(2) ? Method::PBD : Method::DIRECT, draw);
	params.iterations = r_bytes.below(14) - 1;
	for (double &load : params.load) {
		load = r_bytes.below(4) == 0 ? r_bytes.odd(r_bytes.between(-30.0, 30.0)) : 0.0;
	}
	return params;
}

// A blade that no patch would hold: coiled, folded, lying, with segments of very different lengths or none. Metres.
void read_rest_pose(Bytes &r_bytes, BladeScene &r_scene, int p_blade) {
	Eigen::Vector3f knot = Eigen::Vector3f::Zero();
	for (int k = 0; k < GRASS_KNOTS; k++) {
		r_scene.set_rest(p_blade, k, knot);
		const float size = r_bytes.below(6) == 0 ? 0.0f : r_scene.length / GRASS_SEGMENTS * float(r_bytes.between(0.1, 2.0));
		knot += (Eigen::Vector3f::UnitY() + r_bytes.within(1.5)).normalized() * size;
		knot.y() = std::abs(knot.y());
	}
}

void read_state(Bytes &r_bytes, BladeScene &r_scene) {
	for (int i = r_bytes.below(6); i > 0; i--) {
		const int blade = r_bytes.below(GRASS_BLADES_PER_TILE), knot = r_bytes.below(GRASS_FREE_KNOTS), axis = r_bytes.below(3);
		const float value = float(r_bytes.odd(r_bytes.between(-1.0, 1.0)));
		TileState &tile = *r_scene.tile;
		switch (r_bytes.below(3)) {
			case 0:
				tile.knots[axis][knot][blade] = value;
				break;
			case 1:
				tile.before[axis][knot][blade] = value;
				break;
			default:
				tile.twist[knot][blade] = value;
		}
	}
}

vec4 read_rotation(Bytes &r_bytes) {
	const Eigen::Vector3f axis = r_bytes.within(1.0);
	const Eigen::Vector4f unit = Eigen::Vector4f(axis.x(), axis.y(), axis.z(), 0.1f).normalized();
	return { unit.x(), unit.y(), unit.z(), unit.w() };
}

void read_collider(Bytes &r_bytes, BladeScene &r_scene) {
	const auto size = [&] { return float(r_bytes.odd(std::pow(10.0, r_bytes.between(-5.0, 1.0)))); };
	const float width = size(), height = size(), depth = size();
	const Eigen::Vector3f place = r_bytes.within(0.6); // each in a line of its own: compilers evaluate arguments in different orders
	GrassCollider &collider = r_scene.add(r_bytes.below(6), place, { width, height, depth });
	if (r_bytes.below(4) == 0) {
		collider.rotation = read_rotation(r_bytes);
		collider.rotation_before = read_rotation(r_bytes);
	}
	collider.position_before.x = float(r_bytes.odd(collider.position.x + r_bytes.between(-2.0, 2.0)));
	collider.position.y = float(r_bytes.odd(collider.position.y));
	collider.position.w = float(r_bytes.odd(r_bytes.share()));
	collider.size.y = float(r_bytes.odd(collider.size.y));
	if (r_bytes.below(16) == 0) {
		collider.anchor.w = r_bytes.byte() - 128;
	}
}

// Returns a segment's error, metres, over what is allowed of it: 1e-3 of the segment and a rounding error of the blade.
float stretch_of(const BladeScene &p_scene) {
	return p_scene.largest([&](int p_blade, int p_knot) {
		const float wanted = (p_scene.rest(p_blade, p_knot) - p_scene.rest(p_blade, p_knot - 1)).norm();
		const float found = (p_scene.knot(p_blade, p_knot) - p_scene.knot(p_blade, p_knot - 1)).norm();
		return std::abs(found - wanted) / (1e-3f * wanted + 1e-6f * p_scene.length);
	});
}

std::string look(const BladeScene &p_scene, int p_frame) {
	std::ostringstream report;
	if (!p_scene.is_finite()) {
		report << "frame " << p_frame << ": not finite";
	} else if (const float stretch = stretch_of(p_scene); !(stretch <= 1.0f)) {
		report << "frame " << p_frame << ": a length is wrong by " << stretch << " times what is allowed";
	}
	return report.str();
}

// With the default parameters and nothing around, blades that a patch could hold are back at rest after some seconds.
std::string calm(BladeScene &r_scene, int p_first_usual) {
	r_scene.colliders.clear();
	const Method method = r_scene.params.method;
	r_scene.params = SolverParams();
	r_scene.params.method = method;
	r_scene.step_for(4.0);
	std::ostringstream report;
	for (int b = p_first_usual; b < GRASS_BLADES_PER_TILE; b++) {
		const float away = (r_scene.knot(b, GRASS_KNOTS - 1) - r_scene.rest(b, GRASS_KNOTS - 1)).norm() / r_scene.length;
		if (!(away < 0.01f)) {
			report << "in the end: blade " << b << " is " << away << " L from rest";
			break;
		}
	}
	return report.str();
}

} // namespace

std::string play_bytes(std::span<const uint8_t> p_bytes) {
	Bytes bytes(p_bytes);
	BladeScene scene;
	scene.params = read_params(bytes);
	scene.step_function = ALL_STEPS[bytes.below(3)];
	const int odd_blades = bytes.below(9);
	for (int b = 0; b < odd_blades; b++) {
		read_rest_pose(bytes, scene, b);
	}
	for (int frame = 0; frame < 24; frame++) {
		double delta = bytes.odd(bytes.between(0.0, 0.1));
		if (frame % 6 == 0) {
			scene.colliders.clear();
			for (int i = bytes.below(6); i > 0; i--) {
				read_collider(bytes, scene);
			}
			read_state(bytes, scene);
			delta = 1.0 / 60.0; // a step of no time would leave a broken state as it is
		}
		scene.step(delta);
		const std::string failure = look(scene, frame);
		if (!failure.empty()) {
			return failure;
		}
	}
	const std::string failure = calm(scene, odd_blades);
	return failure.empty() ? look(scene, -1) : failure;
}

} // namespace grass::test
