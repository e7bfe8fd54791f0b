# SPDX-License-Identifier: MIT
"""Packs the SPIR-V of compute passes, which were half of the library: extension/core/base/packed_pass.h describes the bytes.

A word that names a result is close to another one that the pass named before; which one, depends on the operation and on the word's place
in it. The packer tries the four guesses on the whole pass, and keeps for each place the one with which the differences repeat most.
"""

import collections
import math

HEADER = 5  # words before the first operation
PLACES = 7  # words of an operation that have guesses of their own; those behind share the last one's
GUESSES = 4
COST = 20  # bits that a new difference costs beyond those that tell it from others


def number(value):
	"""An unsigned number of seven bits a byte, the lowest first."""
	made = bytearray()
	while value >= 128:
		made.append(value & 127 | 128)
		value >>= 7
	return bytes([*made, value])


def folded(difference):
	"""A difference of words as a number that is small if it is near 0 on either side."""
	value = difference & 0xFFFFFFFF
	return value << 1 if value < 1 << 31 else ((1 << 32) - value << 1) - 1


def differences(words):
	"""Yields for each operation its number, its length, and for each further word (place, differences from all guesses)."""
	known = collections.defaultdict(lambda: [0] * PLACES)
	result, at = 0, HEADER
	while at < len(words):
		operation, length = words[at] & 0xFFFF, words[at] >> 16
		before, own, found = known[operation], words[at + 2] if length > 2 else 0, []
		for index in range(1, length):
			place, word = min(index, PLACES) - 1, words[at + index]
			guesses = (0, result, before[place], own if index > 2 else result)
			found.append((place, tuple(folded(word - guess) for guess in guesses)))
			before[place] = word
		yield operation, length, found
		result = own if length > 2 else result
		at += length


def cost(counts):
	total = sum(counts.values())
	return len(counts) * COST - sum(count * math.log2(count / total) for count in counts.values())


def choices(operations):
	"""operation -> the guess for each place, two bits each."""
	seen = collections.defaultdict(lambda: [collections.Counter() for _ in range(GUESSES)])
	for operation, _, found in operations:
		for place, values in found:
			for counts, value in zip(seen[operation, place], values):
				counts[value] += 1
	chosen = collections.Counter()
	for (operation, place), guesses in sorted(seen.items()):
		chosen[operation] |= min(range(GUESSES), key=lambda guess: cost(guesses[guess])) << 2 * place
	return chosen


def pack(words):
	"""The bytes of a pass."""
	operations = list(differences(words))
	chosen = choices(operations)
	made = [number(len(words)), *map(number, words[:HEADER]), number(len(chosen))]
	made += [number(value) for row in chosen.items() for value in row]
	for operation, length, found in operations:
		made += [number(operation), number(length)]
		made += [number(values[chosen[operation] >> 2 * place & GUESSES - 1]) for place, values in found]
	return b"".join(made)
