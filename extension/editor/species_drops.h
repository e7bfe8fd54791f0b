// SPDX-License-Identifier: MIT
// Lets the editor's 3D views take species while some are dragged: the views refuse what they do not know.
#pragma once

#include "editor/view_drop.h"

#include <vector>

namespace grass {

class SpeciesDrops {
public:
	// Covers the views if p_dragged has species. p_dropped: called with the field and the species, an Array.
	void begin(const godot::Variant &p_dragged, const godot::Callable &p_dropped);
	void end();

private:
	std::vector<ViewDrop *> _drops; // exist while species are dragged
};

} // namespace grass
