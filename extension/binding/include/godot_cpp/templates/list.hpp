// SPDX-License-Identifier: MIT
// A linked list under the engine's name.
#pragma once

#include <godot_cpp/core/element_iterator.hpp>

#include <list>

namespace godot {

template <typename T> class List {
	using Iterator = internal::ElementIterator<T, typename std::list<T>::iterator>;
	using ConstIterator = internal::ElementIterator<const T, typename std::list<T>::const_iterator>;

public:
	List() = default;
	explicit List(const List &) = default; // a copy is to be seen
	List(List &&) = default;
	List &operator=(const List &) = default;
	List &operator=(List &&) = default;

	void push_back(const T &p_value) { _values.push_back(p_value); }
	void clear() { _values.clear(); }
	int size() const { return static_cast<int>(_values.size()); }
	bool is_empty() const { return _values.empty(); }
	Iterator begin() { return _values.begin(); }
	Iterator end() { return _values.end(); }
	ConstIterator begin() const { return _values.begin(); }
	ConstIterator end() const { return _values.end(); }

private:
	std::list<T> _values;
};

} // namespace godot
