// SPDX-License-Identifier: MIT
// Scenes of random blades, bodies and parameters that any lane width steps: every number follows from a seed, on every platform.
#pragma once

#include "blade_scene.h"
#include "draw_params.h"

#include <random>
#include <string>

namespace grass::test {

// Which scenes: of everyday parameters and bodies, or of everything that may come.
enum class Range { EVERYDAY, WILD };

class RandomScene {
public:
	RandomScene(uint32_t p_seed, Range p_range) : _engine(p_seed), _range(p_range) {
		_scene.params = draw(below(2) ? Method::PBD : Method::DIRECT);
		_has_species = below(4) == 0;
		_second = draw(_scene.params.method);
		_second.iterations = _scene.params.iterations;
		place_blades();
		add_bodies();
	}

	// The blades of the next step start from the same bits, whoever steps them.
	const BladeScene &get_scene() const { return _scene; }
	TileState &get_tile() { return *_scene.tile; }

	// Moves bodies and time on by one step.
	void advance() {
		const double delta = is_wild() && below(4) == 0 ? uniform(0.0, 0.2) * below(2) : 1.0 / 60.0;
		if (is_wild() && below(8) == 0) {
			_scene.params = draw(_scene.params.method);
			_second.iterations = _scene.params.iterations;
		}
		for (size_t i = 0; i < _bodies.size(); i++) {
			move(_scene.colliders[i], _bodies[i], float(delta));
		}
		_steps[0] = _scene.clock.advance(_scene.params, delta);
		_steps[1] = _scene.clock.repeat(_second);
		_blend = is_wild() && below(6) == 0 ? float(uniform(0.0, 1.1)) : 0.0f;
		_colliders = _scene.tile_colliders();
	}
	// What advance() has prepared, for a tile of this scene.
	float step(Step p_step, TileState &r_tile) const { return p_step(r_tile, { _steps, _has_species ? 2u : 1u }, _blend, _colliders); }

private:
	struct Body {
		Eigen::Vector3f place, velocity, turn, spin; // turn: axis times the tangent of half the angle; spin: what a second adds to it
	};

	bool is_wild() const { return _range == Range::WILD; }
	int below(int p_count) { return int(_engine() % uint32_t(p_count)); }
	double uniform(double p_low, double p_high) { return p_low + (p_high - p_low) * (double(_engine()) / 4294967296.0); }
	Eigen::Vector3f within(double p_size) {
		const auto part = [&] { return float(uniform(-p_size, p_size)); };
		const float x = part(), y = part();
		return { x, y, part() };
	}

	SolverParams draw(Method p_method) {
		SolverParams params;
		params.method = p_method;
		if (is_wild()) {
			params = draw_params(p_method, [&](const Tunable &p_tunable) { return uniform(p_tunable.minimum, p_tunable.maximum); });
			params.iterations = 1 + below(4);
			for (double &load : params.load) {
				load = below(6) == 0 ? uniform(-20.0, 20.0) : 0.0;
			}
		}
		return params;
	}

	// All over the tile; some stand straight at rest, others lean and curve ever more and are bent aside.
	void place_blades() {
		TileState &tile = *_scene.tile;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			tile.root[0][b] = float(uniform(-0.25, 0.25));
			tile.root[2][b] = float(uniform(-0.25, 0.25));
			tile.species[b] = uint8_t(below(2));
			const Eigen::Vector3f lean = within(b % 8 == 0 ? 0.0 : 0.4), curve = within(b % 8 == 0 ? 0.0 : 0.8);
			const Eigen::Vector3f bent = within(b % 4 == 0 ? 0.0 : 1.5);
			const float part = float(uniform(0.5, 1.0)) * _scene.length;
			Eigen::Vector3f rest = Eigen::Vector3f::Zero(), knot = rest;
			for (int k = 0; k < GRASS_KNOTS; k++) {
				_scene.set_rest(b, k, rest);
				_scene.set_knot(b, k, knot);
				const float share = float(knot_share(k)), segment = part * float(segment_share(k));
				const Eigen::Vector3f way = Eigen::Vector3f::UnitY() + lean + curve * share;
				rest += way.normalized() * segment;
				if (b % 16 == 0 && k >= GRASS_CLAMPED_KNOTS) { // at rest but for a last bit of twist
					tile.twist[k - GRASS_CLAMPED_KNOTS][b] = 1e-7f;
				}
				knot += (k < 1 ? way : Eigen::Vector3f(way + bent * share)).normalized() * segment;
			}
		}
	}

	void add_bodies() {
		const int count = is_wild() ? below(6) : 1 + below(3);
		for (int i = 0; i < count; i++) {
			const auto size = [&] { return float(is_wild() ? uniform(0.003, 0.5) : uniform(0.025, 0.3)); };
			const float x = size(), y = size();
			std::vector<Eigen::Vector4f> planes = std::move(_scene.planes); // add() makes those of one hull
			const int first = int(planes.size()), shape = SHAPES[below(5)];
			GrassCollider &collider = _scene.add(shape, Eigen::Vector3f::Zero(), { x, y, size() });
			if (shape == GRASS_HULL) {
				collider.anchor.w = first;
				planes.insert(planes.end(), _scene.planes.begin(), _scene.planes.end());
			}
			_scene.planes = std::move(planes);
			Body body{ within(0.5), within(below(4) == 0 ? 0.0 : is_wild() ? 30.0 : 3.0), within(0.7), within(below(2) ? 0.0 : 4.0) };
			body.place.y() = std::abs(body.place.y());
			body.place -= body.velocity * 0.15f; // it comes by within the first steps
			_bodies.push_back(body);
			move(collider, _bodies.back(), 0.0f);
		}
	}
	void move(GrassCollider &r_collider, Body &r_body, float p_delta) {
		const Body before = r_body;
		r_body.place += r_body.velocity * p_delta;
		r_body.turn += r_body.spin * p_delta;
		if (is_wild() && below(20) == 0) {
			r_body.place = within(0.5); // and all of the way is its path
		}
		BladeScene::place(r_collider, before.place, r_body.place);
		r_collider.rotation_before = quaternion(before.turn);
		r_collider.rotation = quaternion(r_body.turn);
	}
	// Without a sine, whose last bit differs between platforms.
	static vec4 quaternion(const Eigen::Vector3f &p_turn) {
		const float scale = 1.0f / std::sqrt(1.0f + p_turn.squaredNorm());
		return { p_turn.x() * scale, p_turn.y() * scale, p_turn.z() * scale, scale };
	}

	std::mt19937 _engine;
	Range _range;
	BladeScene _scene;
	SolverParams _second; // of the other species
	std::vector<Body> _bodies;
	std::vector<TileCollider> _colliders;
	GrassStep _steps[2];
	float _blend = 0.0f;
	bool _has_species = false;
};

inline bool are_same(const TileState &p_a, const TileState &p_b) {
	return std::memcmp(p_a.knots, p_b.knots, sizeof(p_a.knots)) == 0 && std::memcmp(p_a.before, p_b.before, sizeof(p_a.before)) == 0 &&
			std::memcmp(p_a.twist, p_b.twist, sizeof(p_a.twist)) == 0;
}

// Returns the first step after which some version has other bits than scalar float; "" if all agree to the end.
inline std::string find_difference(uint32_t p_seed, Range p_range, int p_steps) {
	RandomScene scene(p_seed, p_range);
	TileState &scalar = scene.get_tile();
	for (int i = 0; i < p_steps; i++) {
		scene.advance();
		const TileState start = scalar;
		const float energy = scene.step(step_scalar_float, scalar);
		for (size_t width = 0; width < get_lane_steps().size(); width++) {
			TileState tile = start;
			const float found = scene.step(get_lane_steps()[width], tile);
			if (!are_same(tile, scalar) || found != energy) {
				return "step " + std::to_string(i) + ", " + std::to_string(4 << width) + " lanes";
			}
		}
	}
	return "";
}

} // namespace grass::test
