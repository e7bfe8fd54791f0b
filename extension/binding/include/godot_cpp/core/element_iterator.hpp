// SPDX-License-Identifier: MIT
// What the loops over the binding's containers go by. It is no iterator by the standard library's rules, as upstream's are not: algorithms
// and std::span take pointers (ptr(), size()).
#pragma once

namespace godot::internal {

template <typename T, typename Place = T *> class ElementIterator {
public:
	ElementIterator() = default;
	ElementIterator(Place p_place) : _place(p_place) {}

	T &operator*() const { return *_place; }
	T *operator->() const { return &*_place; }
	ElementIterator &operator++() {
		++_place;
		return *this;
	}
	ElementIterator &operator--() {
		--_place;
		return *this;
	}
	bool operator==(const ElementIterator &p_other) const { return _place == p_other._place; }
	bool operator!=(const ElementIterator &p_other) const { return _place != p_other._place; }

private:
	Place _place = {};
};

} // namespace godot::internal
