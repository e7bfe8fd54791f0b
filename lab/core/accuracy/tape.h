// SPDX-License-Identifier: MIT
// The reference problems for a machine that the rest of the benchmark does not run on: a tape records every step that a
// problem takes, lab/project/bench/bench_accuracy.gd runs them on a GPU, and the tape then plays the knots that came
// back to the very same problems, which so compute errors in one place.
// Files are rows of 32-bit words. NAME.pack: magic, knots, states, takes; the patch's texels (RGBA, 64 blades); states, each
// knots and knots before as TileState has them; takes, each Take, runs of (steps, GrassStep), and one GrassCollider for every
// step if it has any. NAME.result: magic, knots, software (0 or 1), takes; takes, each a count and so many floats.
#pragma once

#include "core/solver/tile_state.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace grass::test {

// What of a take is wanted back.
enum class Keep : uint32_t {
	TIP, // x of the tip of blade 0
	KNOTS, // all free knots, as TileState has them
	TIME, // milliseconds that its steps take with 65,536 blades
};

class Tape {
public:
	static constexpr uint32_t PACK = 0x4b434150, RESULT = 0x544c5352; // "PACK", "RSLT"

	virtual ~Tape() = default;
	// A problem begins, of which something is kept after every p_stride steps.
	virtual void begin(Keep p_keep, int p_stride) = 0;
	virtual void step(TileState &r_state, const GrassStep &p_step, std::span<const TileCollider> p_colliders) = 0;
	virtual double milliseconds() const { return 0.0; } // of the take, if it keeps time
};

// The tape that step_on_tape writes to or reads from: a step function carries no data of its own.
inline Tape *tape = nullptr;

inline float step_on_tape(TileState &r_state, std::span<const GrassStep> p_steps, float, std::span<const TileCollider> p_colliders) {
	tape->step(r_state, p_steps[0], p_colliders);
	return 0.0f;
}

class Recorder : public Tape {
public:
	void begin(Keep p_keep, int p_stride) override {
		_takes.emplace_back();
		_takes.back().keep = p_keep;
		_takes.back().stride = uint32_t(p_stride);
	}

	void step(TileState &r_state, const GrassStep &p_step, std::span<const TileCollider> p_colliders) override {
		Take &take = _takes.back();
		if (take.steps == 0) {
			take.state = find_state(r_state);
		}
		GrassStep step = p_step;
		step.field = { 0.5f, 1.0f, 1.0f, float(GRASS_KNOTS) };
		step.clump = { 1.0f, 0.0f, 0.0f, 0.0f }; // no clumps: the patch's knots as they are
		if (take.runs.empty() || std::memcmp(&take.runs.back().step, &step, sizeof(step)) != 0) {
			take.runs.push_back({ 0, step });
		}
		take.runs.back().steps++;
		take.steps++;
		for (const TileCollider &collider : p_colliders) {
			take.colliders.push_back(record_of(collider));
		}
	}

	void write(const std::string &p_path) const {
		std::ofstream file(p_path, std::ios::binary);
		const auto words = [&](const void *p_data, size_t p_bytes) {
			file.write(static_cast<const char *>(p_data), std::streamsize(p_bytes));
		};
		const uint32_t header[] = { PACK, GRASS_KNOTS, uint32_t(_states.size()), uint32_t(_takes.size()) };
		words(header, sizeof(header));
		words(_patch.data(), _patch.size() * sizeof(float));
		for (const std::vector<float> &state : _states) {
			words(state.data(), state.size() * sizeof(float));
		}
		for (const Take &take : _takes) {
			const uint32_t head[] = { uint32_t(take.keep), take.stride, take.state, take.steps, uint32_t(take.runs.size()),
				!take.colliders.empty() };
			words(head, sizeof(head));
			for (const Run &run : take.runs) {
				words(&run.steps, sizeof(run.steps));
				words(&run.step, sizeof(run.step));
			}
			words(take.colliders.data(), take.colliders.size() * sizeof(GrassCollider));
		}
		if (!file.flush()) {
			throw std::runtime_error("cannot write " + p_path);
		}
	}

private:
	struct Run {
		uint32_t steps;
		GrassStep step;
	};
	struct Take {
		Keep keep = Keep::TIP;
		uint32_t stride = 1, state = 0, steps = 0;
		std::vector<Run> runs;
		std::vector<GrassCollider> colliders; // one a step, or none
	};

	std::vector<float> _patch;
	std::vector<std::vector<float>> _states;
	std::vector<Take> _takes;

	uint32_t find_state(const TileState &p_state) {
		if (_patch.empty()) { // the same blades in all problems
			for (int i = 0; i < GRASS_BLADES_PER_TILE * GRASS_KNOTS; i++) {
				const int b = i % GRASS_BLADES_PER_TILE, k = i / GRASS_BLADES_PER_TILE;
				const float knot[4] = { p_state.rest[0][k][b], p_state.rest[1][k][b], p_state.rest[2][k][b], 0.0f };
				const float root[4] = { 0.5f, 0.5f, 0.0f, 0.0f }; // the middle of the tile
				_patch.insert(_patch.end(), k == 0 ? root : knot, (k == 0 ? root : knot) + 4);
			}
		}
		constexpr size_t COUNT = sizeof(p_state.knots) / sizeof(float);
		std::vector<float> state(&p_state.knots[0][0][0], &p_state.knots[0][0][0] + COUNT);
		state.insert(state.end(), &p_state.before[0][0][0], &p_state.before[0][0][0] + COUNT);
		for (size_t i = 0; i < _states.size(); i++) {
			if (_states[i] == state) {
				return uint32_t(i);
			}
		}
		_states.push_back(state);
		return uint32_t(_states.size() - 1);
	}

	static GrassCollider record_of(const TileCollider &p_collider) {
		const Vec3<float> now = p_collider.centre, before = p_collider.centre_before, size = p_collider.size;
		const Turn<float> turn = p_collider.turn, turn_before = p_collider.turn_before;
		return { { 0, 0, p_collider.shape, 0 }, { now.x, now.y, now.z, p_collider.friction },
			{ turn.axis.x, turn.axis.y, turn.axis.z, turn.w }, { before.x, before.y, before.z, 0.0f },
			{ turn_before.axis.x, turn_before.axis.y, turn_before.axis.z, turn_before.w }, { size.x, size.y, size.z, 0.0f } };
	}
};

class Player : public Tape {
public:
	explicit Player(const std::string &p_path) : _path(p_path) {
		std::ifstream file(p_path, std::ios::binary);
		std::vector<char> bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
		_words.resize(bytes.size() / 4);
		std::memcpy(_words.data(), bytes.data(), _words.size() * 4);
		if (next() != RESULT || next() != GRASS_KNOTS) {
			fail("is no result for this number of knots");
		}
		_is_software = next() != 0;
		_takes = next();
	}

	void begin(Keep p_keep, int p_stride) override {
		_at = _end;
		if (_takes-- == 0) {
			fail("has too few takes: was it made from the packs of --quick?");
		}
		const uint32_t count = next();
		_end = _at + count;
		if (_end > _words.size()) {
			fail("is cut off");
		}
		_keep = p_keep;
		_stride = p_stride;
		_steps = 0;
		_milliseconds = p_keep == Keep::TIME ? number() : 0.0;
	}

	void step(TileState &r_state, const GrassStep &, std::span<const TileCollider>) override {
		if (_keep == Keep::TIME || ++_steps % _stride != 0) {
			return;
		}
		if (_keep == Keep::TIP) {
			r_state.knots[0][GRASS_FREE_KNOTS - 1][0] = number();
		} else {
			for (float *knot = &r_state.knots[0][0][0], *end = knot + sizeof(r_state.knots) / sizeof(float); knot != end; knot++) {
				*knot = number();
			}
		}
	}

	double milliseconds() const override { return _milliseconds; }
	bool is_software() const { return _is_software; }
	// All of the file is used up.
	void finish() const {
		if (_takes != 0 || _end != _words.size()) {
			fail("holds more than this benchmark asked for: was it made by another version?");
		}
	}

private:
	std::string _path;
	std::vector<uint32_t> _words;
	size_t _at = 0, _end = 4; // of the take
	uint32_t _takes = 0; // still to come
	Keep _keep = Keep::TIP;
	int _stride = 1, _steps = 0;
	double _milliseconds = 0.0;
	bool _is_software = false;

	[[noreturn]] void fail(const std::string &p_text) const { throw std::runtime_error(_path + " " + p_text); }
	uint32_t next() {
		if (_at >= _words.size()) {
			fail("is cut off");
		}
		return _words[_at++];
	}
	float number() {
		if (_at >= _end) {
			fail("keeps too little of a take: was it made by another version?");
		}
		const uint32_t word = next();
		float value;
		std::memcpy(&value, &word, sizeof(value));
		return value;
	}
};

} // namespace grass::test
