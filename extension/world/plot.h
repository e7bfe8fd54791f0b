// SPDX-License-Identifier: MIT
// A plot of a world, from the request for its file until its field has left.
#pragma once

#include "world/world_fields.h"

#include <map>

namespace grass {

struct Plot {
	enum class State {
		ASKED,
		READ,
		COMING, // its field is being made
		STANDING,
		EMPTY, // a script took its field away before that
	};
	GrassField *get_field() const { return field != 0 ? field_with(field) : nullptr; }

	State state = State::ASKED;
	int64_t ask = 0; // the request to answer
	uint64_t field = 0; // instance id, since a script may free it
	PaintMap known; // as it is in its file
	std::unique_ptr<ShownMap> prepared;
	FieldMemory memory; // when it was measured last
};

using Plots = std::map<PlotKey, Plot>;

} // namespace grass
