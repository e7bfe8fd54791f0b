// SPDX-License-Identifier: MIT
// The way from one node to another, or to a property.
#pragma once

#include <godot_cpp/variant/string_name.hpp>

namespace godot {

class NodePath : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_NODE_PATH, 1> {
public:
	NodePath() = default;
	NodePath(const String &p_from) : Opaque(2, &p_from) {}
	NodePath(const char *p_from) : NodePath(String(p_from)) {}
	NodePath(const Variant *) = delete; // private upstream

#include <godot_cpp/variant/gen/node_path.inc>
};

inline String::String(const NodePath &p_from) : Opaque(3, &p_from) {}

} // namespace godot
