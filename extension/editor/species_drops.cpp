// SPDX-License-Identifier: MIT
#include "editor/species_drops.h"

#include "editor/species_drop.h"

using namespace godot;

namespace grass {

namespace {

constexpr int32_t VIEWS = 4; // of the editor, shown or not

} // namespace

void SpeciesDrops::begin(const Variant &p_dragged, const Callable &p_dropped) {
	end();
	if (find_dragged_species(p_dragged).is_empty()) {
		return;
	}
	for (int32_t view = 0; view < VIEWS; view++) {
		_drops.push_back(ViewDrop::create(view));
		_drops.back()->connect("species_dropped", p_dropped);
	}
}

void SpeciesDrops::end() {
	for (ViewDrop *drop : _drops) {
		drop->queue_free(); // may be the one that took it
	}
	_drops.clear();
}

} // namespace grass
