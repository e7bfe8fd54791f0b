// SPDX-License-Identifier: MIT
// A growing array under the engine's name, with value semantics.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace godot {

template <typename T> class Vector {
public:
	Vector() = default;
	Vector(std::initializer_list<T> p_values) : _values(p_values) {}

	void push_back(const T &p_value) { _values.push_back(p_value); }
	void resize(int64_t p_size) { _values.resize(p_size); }
	void reserve(int64_t p_size) { _values.reserve(p_size); }
	void clear() { _values.clear(); }
	int64_t size() const { return static_cast<int64_t>(_values.size()); }
	bool is_empty() const { return _values.empty(); }
	T *ptr() { return _values.data(); }
	const T *ptr() const { return _values.data(); }
	T *ptrw() { return _values.data(); }
	T &operator[](int64_t p_index) { return _values[p_index]; }
	const T &operator[](int64_t p_index) const { return _values[p_index]; }
	auto begin() { return _values.begin(); }
	auto end() { return _values.end(); }
	auto begin() const { return _values.begin(); }
	auto end() const { return _values.end(); }

private:
	std::vector<T> _values;
};

} // namespace godot
