// SPDX-License-Identifier: MIT
// What the ten packed arrays have in common: contiguous numbers (or vectors, colours, texts), shared until changed.
#pragma once

#include <godot_cpp/core/builtin_call.hpp>
#include <godot_cpp/core/element_iterator.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/array.hpp>

#include <initializer_list>

namespace godot::internal {

// The first element: for reading as it is, for writing after unsharing. Null when empty.
const void *packed_read(GDExtensionVariantType p_type, const void *p_array);
void *packed_write(GDExtensionVariantType p_type, void *p_array);

template <typename Self, typename Element, GDExtensionVariantType TYPE> class PackedArray : public Opaque<TYPE, 2> {
public:
	PackedArray() = default;
	PackedArray(std::initializer_list<Element> p_values) {
		self().resize(static_cast<int64_t>(p_values.size()));
		Element *to = ptrw();
		for (const Element &value : p_values) {
			*to++ = value;
		}
	}

	const Element *ptr() const { return count() ? static_cast<const Element *>(packed_read(TYPE, this)) : nullptr; }
	Element *ptrw() { return count() ? static_cast<Element *>(packed_write(TYPE, this)) : nullptr; }
	const Element &operator[](int64_t p_index) const {
		CRASH_BAD_INDEX(p_index, count());
		return ptr()[p_index];
	}
	Element &operator[](int64_t p_index) {
		CRASH_BAD_INDEX(p_index, count());
		return ptrw()[p_index];
	}
	ElementIterator<Element> begin() { return ptrw(); }
	ElementIterator<Element> end() { return ptrw() + count(); }
	ElementIterator<const Element> begin() const { return ptr(); }
	ElementIterator<const Element> end() const { return ptr() + count(); }

protected:
	explicit PackedArray(int p_constructor, const Array *p_from) : Opaque<TYPE, 2>(p_constructor, p_from) {}

private:
	Self &self() { return static_cast<Self &>(*this); }
	int64_t count() const { return static_cast<const Self *>(this)->size(); }
};

} // namespace godot::internal
