// SPDX-License-Identifier: MIT
// A set of slots of the pool, one bit for each. Finds the lowest slot in a time that does not depend on the number of slots in the set.
#pragma once

#include "core/base/resize_exactly.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace grass {

class SlotSet {
public:
	static constexpr int NONE = -1;

	// Resets the set to slots 0 .. p_size - 1: all in the set, or none.
	void reset(int p_size, bool p_full) {
		_words.assign(size_t(p_size + 63) / 64, p_full ? ~uint64_t(0) : 0);
		if (p_full && p_size % 64 != 0) {
			_words.back() = (uint64_t(1) << (p_size % 64)) - 1;
		}
		_first = 0;
	}

	// Changes the number of slots. The set keeps those that still exist; new ones are in it if p_full.
	void resize(int p_before, int p_size, bool p_full) {
		resize_exactly(_words, size_t(p_size + 63) / 64);
		for (int slot = p_before; slot < p_size; slot++) {
			insert_if(slot, p_full);
		}
		if (p_size % 64 != 0) {
			_words.back() &= (uint64_t(1) << (p_size % 64)) - 1;
		}
		_first = 0;
	}

	void insert(int p_slot) { insert_if(p_slot, true); }

	// Inserts the slot or does nothing. Branch-free, since the branch would be mispredicted.
	void insert_if(int p_slot, bool p_condition) { _words[size_t(p_slot) / 64] |= uint64_t(p_condition) << (p_slot % 64); }

	// Returns a slot to a set from which take_lowest() takes slots.
	void give_back(int p_slot) {
		insert(p_slot);
		_first = std::min(_first, size_t(p_slot) / 64);
	}

	void erase(int p_slot) { _words[size_t(p_slot) / 64] &= ~(uint64_t(1) << (p_slot % 64)); }

	bool has(int p_slot) const { return (_words[size_t(p_slot) / 64] >> (p_slot % 64) & 1) != 0; }

	void clear() { std::fill(_words.begin(), _words.end(), 0); }

	int count() const {
		int count = 0;
		for (const uint64_t word : _words) {
			count += std::popcount(word);
		}
		return count;
	}

	// Sets this to the slots in p_a that are not in p_b, a set of the same size.
	void take_difference(const SlotSet &p_a, const SlotSet &p_b) {
		_words.resize(p_a._words.size());
		for (size_t i = 0; i < _words.size(); i++) {
			_words[i] = p_a._words[i] & ~p_b._words[i];
		}
		_first = 0;
	}

	// Adds the slots of a set of the same size.
	void insert_all(const SlotSet &p_others) {
		for (size_t i = 0; i < _words.size(); i++) {
			_words[i] |= p_others._words[i];
		}
	}

	bool is_empty() const {
		return std::all_of(_words.begin(), _words.end(), [](uint64_t p_word) { return p_word == 0; });
	}

	// Iterates over all slots, ascending: `for (const int slot : set)`. The current slot may be removed meanwhile.
	class Iterator {
	public:
		Iterator(const uint64_t *p_word, const uint64_t *p_end) : _begin(p_word), _word(p_word), _end(p_end) { skip_empty(); }
		int operator*() const { return int(_word - _begin) * 64 + std::countr_zero(_bits); }
		void operator++() {
			_bits &= _bits - 1;
			if (_bits == 0) {
				_word++;
				skip_empty();
			}
		}
		bool operator!=(const Iterator &) const { return _word != _end; }

	private:
		void skip_empty() {
			while (_word != _end && (_bits = *_word) == 0) {
				_word++;
			}
		}

		const uint64_t *_begin, *_word, *_end;
		uint64_t _bits = 0; // of the word, from the current slot on
	};
	Iterator begin() const { return { _words.data(), _words.data() + _words.size() }; }
	Iterator end() const { return { _words.data() + _words.size(), _words.data() + _words.size() }; }

	// Removes the lowest slot and returns it, or NONE if the set is empty.
	int take_lowest() {
		while (_first < _words.size() && _words[_first] == 0) {
			_first++;
		}
		if (_first == _words.size()) {
			return NONE;
		}
		const int slot = int(_first * 64) + std::countr_zero(_words[_first]);
		erase(slot);
		return slot;
	}

	size_t get_memory_usage() const { return _words.capacity() * sizeof(uint64_t); } // Bytes.

private:
	std::vector<uint64_t> _words;
	size_t _first = 0; // No word below this one has a slot that was given back.
};

} // namespace grass
