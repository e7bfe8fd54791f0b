// SPDX-License-Identifier: MIT
// A linked list under the engine's name.
#pragma once

#include <list>

namespace godot {

template <typename T> class List {
public:
	void push_back(const T &p_value) { _values.push_back(p_value); }
	void clear() { _values.clear(); }
	int size() const { return static_cast<int>(_values.size()); }
	bool is_empty() const { return _values.empty(); }
	auto begin() { return _values.begin(); }
	auto end() { return _values.end(); }
	auto begin() const { return _values.begin(); }
	auto end() const { return _values.end(); }

private:
	std::list<T> _values;
};

} // namespace godot
