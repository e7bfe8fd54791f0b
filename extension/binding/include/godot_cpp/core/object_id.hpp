// SPDX-License-Identifier: MIT
// The number of an object, valid beyond its life (it then finds nothing).
#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

class ObjectID {
public:
	ObjectID() = default;
	explicit ObjectID(uint64_t p_id) : _id(p_id) {}
	explicit ObjectID(int64_t p_id) : _id(static_cast<uint64_t>(p_id)) {}

	bool is_valid() const { return _id != 0; }
	bool is_null() const { return _id == 0; }
	operator uint64_t() const { return _id; }
	operator int64_t() const { return static_cast<int64_t>(_id); }

	void operator=(uint64_t p_id) { _id = p_id; }
	void operator=(int64_t p_id) { _id = static_cast<uint64_t>(p_id); }
	bool operator==(const ObjectID &p_other) const { return _id == p_other._id; }
	bool operator!=(const ObjectID &p_other) const { return _id != p_other._id; }
	bool operator<(const ObjectID &p_other) const { return _id < p_other._id; }

private:
	uint64_t _id = 0;
};

} // namespace godot
