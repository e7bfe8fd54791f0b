// SPDX-License-Identifier: MIT
// How far the chain is, while a ball rolls through blades, from a rod that shares nothing with it: point masses on stiff springs that
// resist stretching and, by second differences, bending; explicit steps; contact by damped penalty forces. Round blades, straight or
// leaning, without friction. Prints a table; lab/results/solver.md quotes it. One core takes some minutes.
#include "blade_scene.h"

#include <Eigen/Dense>

#include <cstdio>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int BLADES = GRASS_BLADES_PER_TILE, SEGMENTS = 128, PLACES = 15;
constexpr double LENGTH = 0.47, RADIUS = 0.15, HEIGHT = 0.156, FROM = -0.62; // metres, of blades and of the ball
constexpr double FREQUENCY = 1.2, DAMPING = 0.5, TAPERS = 0.3, LEAN = 0.35; // Hz, ratio, share, radians
constexpr double STEP = 4e-6; // seconds
constexpr int FRAMES = 60; // a second

using Numbers = Eigen::Array<double, BLADES, 1>; // one of each blade
using Places = std::vector<Eigen::Vector3f>; // [frame][blade][place], metres

double seconds_of(double p_speed) {
	return std::ceil(FRAMES * (1.15 / p_speed + 0.3)) / FRAMES;
}
double offset_of(int p_blade) {
	return 0.1 * (p_blade + 0.5) / BLADES * (p_blade % 2 == 0 ? -1.0 : 1.0);
}
Eigen::Vector3d direction_of(int p_blade) {
	const double lean = p_blade % 4 >= 2 ? LEAN : 0.0, heading = 2.4 * p_blade;
	return { std::sin(lean) * std::cos(heading), std::cos(lean), std::sin(lean) * std::sin(heading) };
}

struct Triple {
	Numbers x = Numbers::Zero(), y = Numbers::Zero(), z = Numbers::Zero();
	void add(const Triple &p_other, double p_share) {
		x += p_other.x * p_share;
		y += p_other.y * p_share;
		z += p_other.z * p_share;
	}
	Numbers length() const { return (x * x + y * y + z * z).sqrt(); }
};

class Rods {
public:
	Rods() : _places(SEGMENTS + 2), _speeds(SEGMENTS + 2), _forces(SEGMENTS + 2) {
		const double size = LENGTH / SEGMENTS;
		for (int k = 0; k <= SEGMENTS; k++) {
			_width.push_back(1.0 - TAPERS * k / SEGMENTS);
			_mass.push_back(_width.back() * size * (k == SEGMENTS ? 0.5 : 1.0));
		}
		// Of the clamped blade: the bend at joint k, below node k + 1, by the places of nodes 1 and up.
		Eigen::MatrixXd bends = Eigen::MatrixXd::Zero(SEGMENTS, SEGMENTS), stiffness = bends;
		for (int k = 0; k < SEGMENTS; k++) {
			bends(k, k) = 1.0;
			if (k > 0) {
				bends(k, k - 1) = -2.0;
			}
			if (k > 1) {
				bends(k, k - 2) = 1.0;
			}
			stiffness += bends.row(k).transpose() * bends.row(k) * (_width[size_t(k)] * (k == 0 ? 2.0 : 1.0) / (size * size * size));
		}
		const Eigen::VectorXd scale = Eigen::Map<Eigen::VectorXd>(&_mass[1], SEGMENTS).cwiseSqrt().cwiseInverse();
		const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(
				scale.asDiagonal() * stiffness * scale.asDiagonal(), Eigen::EigenvaluesOnly);
		const double swing = 2.0 * std::numbers::pi * FREQUENCY;
		_bending = swing * swing / modes.eigenvalues()[0] / (size * size * size);
		const double fastest = swing * std::sqrt(modes.eigenvalues()[SEGMENTS - 1] / modes.eigenvalues()[0]); // rad/s
		_stretching = 0.36 * fastest * fastest * size; // its waves are about as fast
		_contact = 0.09 * fastest * fastest;
		for (int b = 0; b < BLADES; b++) {
			_root[b] = offset_of(b);
			for (int j = 0; j < SEGMENTS + 2; j++) {
				const Eigen::Vector3d at = direction_of(b) * ((j - 1) * size); // 0 lies below the root, and clamps it
				_places[size_t(j)].x[b] = at.x();
				_places[size_t(j)].y[b] = at.y();
				_places[size_t(j)].z[b] = at.z();
			}
		}
	}

	// p_ball: where its centre is, metres; p_speed: of it, m/s.
	void step(double p_delta, double p_ball, double p_speed) {
		for (Triple &force : _forces) {
			force = {};
		}
		const double size = LENGTH / SEGMENTS;
		for (size_t j = 1; j < SEGMENTS + 1; j++) {
			Triple segment = _places[j + 1];
			segment.add(_places[j], -1.0);
			const Numbers length = segment.length();
			const Numbers pull = (length - size) / length * (_stretching * (1.0 - TAPERS * (double(j) - 0.5) / SEGMENTS));
			segment = { segment.x * pull, segment.y * pull, segment.z * pull };
			_forces[j].add(segment, 1.0);
			_forces[j + 1].add(segment, -1.0);
			Triple bend = _places[j - 1];
			bend.add(_places[j], -2.0);
			bend.add(_places[j + 1], 1.0);
			const double stiffness = _bending * _width[j - 1] * (j == 1 ? 2.0 : 1.0);
			_forces[j].add(bend, 2.0 * stiffness);
			_forces[j + 1].add(bend, -stiffness);
			_forces[j - 1].add(bend, -stiffness);
		}
		for (size_t j = 2; j < SEGMENTS + 2; j++) {
			move(j, p_delta, p_ball, p_speed);
		}
	}
	void look(Places &r_places) const {
		for (int b = 0; b < BLADES; b++) {
			for (int p = 1; p <= PLACES; p++) {
				const double at = double(p) * SEGMENTS / PLACES;
				const size_t j = size_t(std::min(int(at), SEGMENTS - 1));
				Triple place = _places[j + 1];
				place.add(_places[j + 1], -(at - double(j)));
				place.add(_places[j + 2], at - double(j));
				r_places.push_back(Eigen::Vector3d(place.x[b], place.y[b], place.z[b]).cast<float>());
			}
		}
	}

private:
	void move(size_t p_node, double p_delta, double p_ball, double p_speed) {
		Triple &place = _places[p_node], &speed = _speeds[p_node];
		const double drag = 2.0 * DAMPING * 2.0 * std::numbers::pi * FREQUENCY, damps = 2.0 * std::sqrt(_contact);
		Triple change;
		change.add(_forces[p_node], 1.0 / _mass[p_node - 1]);
		change.add(speed, -drag);
		const Triple away{ place.x - p_ball, place.y - HEIGHT, place.z + _root };
		const Numbers distance = away.length(), gap = distance - RADIUS;
		const Numbers nearing = ((speed.x - p_speed) * away.x + speed.y * away.y + speed.z * away.z) / distance;
		const Numbers push = (gap < 0.0).select((-_contact * gap - damps * nearing).max(0.0), Numbers::Zero()) / distance;
		change.x += push * away.x;
		change.y += push * away.y + (place.y < 0.0).select((-_contact * place.y - damps * speed.y).max(0.0), Numbers::Zero());
		change.z += push * away.z;
		speed.add(change, p_delta);
		place.add(speed, p_delta);
	}

	std::vector<Triple> _places, _speeds, _forces;
	std::vector<double> _width, _mass; // of a node, over those of a metre at the root
	Numbers _root; // z of each blade's, metres
	double _bending = 0.0, _stretching = 0.0, _contact = 0.0;
};

Places roll_through_rods(double p_speed) {
	Rods rods;
	Places places;
	const int steps = int(std::ceil(1.0 / FRAMES / STEP));
	for (int frame = 0; frame < int(seconds_of(p_speed) * FRAMES + 0.5); frame++) {
		for (int i = 0; i < steps; i++) {
			rods.step(1.0 / FRAMES / steps, FROM + p_speed * (frame + double(i) / steps) / FRAMES, p_speed);
		}
		rods.look(places);
	}
	return places;
}

struct Way {
	const char *name;
	double rate; // steps a second
	int iterations;
	double contact_rate;
};
Places roll_through_chains(double p_speed, const Way &p_way) {
	BladeScene scene{ float(LENGTH) };
	scene.params.natural_frequency = FREQUENCY;
	scene.params.damping_ratio = DAMPING;
	scene.params.taper = TAPERS;
	scene.params.width_to_thickness = 1.0;
	scene.params.friction = 0.0; // also that of the ground
	scene.params.iterations = p_way.iterations;
	scene.params.contact_rate = p_way.contact_rate;
	for (int b = 0; b < BLADES; b++) {
		scene.tile->root[2][b] = float(offset_of(b));
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, (direction_of(b) * (LENGTH * knot_share(k))).cast<float>());
		}
	}
	scene.add(GRASS_SPHERE, { 0.0f, 0.0f, 0.0f }, { float(RADIUS), 0.0f, 0.0f });
	Places places;
	for (int i = 0; i < int(seconds_of(p_speed) * p_way.rate + 0.5); i++) {
		const auto place = [&](int p_step) { return Eigen::Vector3f(float(FROM + p_speed * p_step / p_way.rate), float(HEIGHT), 0.0f); };
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.colliders[0].position.w = 0.0f;
		scene.step(1.0 / p_way.rate);
		for (int b = 0; b < BLADES && (i + 1) % int(p_way.rate / FRAMES + 0.5) == 0; b++) {
			for (int p = 1; p <= PLACES; p++) {
				places.push_back(scene.place(b, double(p) / PLACES));
			}
		}
	}
	return places;
}

// Root mean squares over time and the places beyond the clamp, in ascending order, blade lengths.
std::vector<double> errors_of(const Places &p_places, const Places &p_right) {
	std::vector<double> errors(BLADES, 0.0);
	const size_t of_blade = PLACES, of_frame = BLADES * of_blade, frames = p_places.size() / of_frame;
	for (size_t i = 0; i < frames * of_frame; i++) {
		if (i % of_blade != 0) {
			errors[i % of_frame / of_blade] += double((p_places[i] - p_right.at(i)).squaredNorm()) / double(frames * (of_blade - 1));
		}
	}
	for (double &error : errors) {
		error = std::sqrt(error) / LENGTH;
	}
	std::ranges::sort(errors);
	return errors;
}

} // namespace

int main() {
	constexpr Way WAYS[] = { { "contact_rate 400", 60.0, 2, 400.0 }, { "contact_rate 800", 60.0, 2, 800.0 },
		{ "contact_rate 1600", 60.0, 2, 1600.0 }, { "5760 steps a second", 5760.0, 8, 400.0 } };
	std::printf("ball_m_s,chain,median_lengths,p90_lengths\n");
	for (const double speed : { 1.0, 3.0, 5.0 }) {
		const Places right = roll_through_rods(speed);
		for (const Way &way : WAYS) {
			const std::vector<double> errors = errors_of(roll_through_chains(speed, way), right);
			std::printf("%g,%s,%.4f,%.4f\n", speed, way.name, errors[BLADES / 2], errors[BLADES * 9 / 10]);
			std::fflush(stdout);
		}
	}
	return 0;
}
