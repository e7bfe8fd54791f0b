// SPDX-License-Identifier: MIT
// The number of a thing that a server owns. Zero is nothing.
#pragma once

#include <godot_cpp/core/builtin_call.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

class RID {
public:
	RID() = default;
	RID(const RID &p_other) : _id(p_other._id) {} // as upstream's, not trivial
	RID &operator=(const RID &p_other) {
		_id = p_other._id;
		return *this;
	}

	int64_t get_id() const { return static_cast<int64_t>(_id); }
	bool is_valid() const { return _id != 0; }
	bool operator==(const RID &p_other) const { return _id == p_other._id; }
	bool operator!=(const RID &p_other) const { return _id != p_other._id; }
	bool operator<(const RID &p_other) const { return _id < p_other._id; }
	void *_native_ptr() const { return const_cast<uint64_t *>(&_id); }

private:
	uint64_t _id = 0;
};

} // namespace godot
