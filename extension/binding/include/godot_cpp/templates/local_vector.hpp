// SPDX-License-Identifier: MIT
// A growing array under the engine's name, with value semantics.
#pragma once

#include <godot_cpp/core/element_iterator.hpp>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace godot {

template <typename T> class LocalVector {
public:
	LocalVector() = default;
	explicit LocalVector(const LocalVector &) = default; // a copy is to be seen
	LocalVector(LocalVector &&) = default;
	LocalVector &operator=(const LocalVector &) = default;
	LocalVector &operator=(LocalVector &&) = default;
	LocalVector(std::initializer_list<T> p_values) : _values(p_values) {}

	void push_back(T p_value) { _values.push_back(std::move(p_value)); }
	void resize(uint32_t p_size) { _values.resize(p_size); }
	void reserve(uint32_t p_size) { _values.reserve(p_size); }
	void clear() { _values.clear(); }
	uint32_t size() const { return static_cast<uint32_t>(_values.size()); }
	bool is_empty() const { return _values.empty(); }
	T *ptr() { return _values.data(); }
	const T *ptr() const { return _values.data(); }
	T &operator[](uint32_t p_index) { return _values[p_index]; }
	const T &operator[](uint32_t p_index) const { return _values[p_index]; }
	internal::ElementIterator<T> begin() { return ptr(); }
	internal::ElementIterator<T> end() { return ptr() + size(); }
	internal::ElementIterator<const T> begin() const { return ptr(); }
	internal::ElementIterator<const T> end() const { return ptr() + size(); }

private:
	std::vector<T> _values;
};

} // namespace godot
