// SPDX-License-Identifier: MIT
// Nodes that do nothing without a resource get a first one when they are added to the edited scene.
#pragma once

#include <godot_cpp/classes/node.hpp>

#include <cstdint>
#include <set>

namespace grass {

class NewNodes {
public:
	// Call it for each node that enters the tree. Returns whether to call furnish() for it once the editor has added it to the scene.
	bool see(const godot::Node &p_node);
	void furnish(uint64_t p_id) const;

private:
	std::set<uint64_t> _seen; // ids: one that undo brings back is not new
};

} // namespace grass
