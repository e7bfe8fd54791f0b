# SPDX-License-Identifier: MIT
"""The flowers, seed heads and leaves of the presets, drawn by numbers: `python3 -m tools.pages.cards` writes their pictures again."""

import math
import random
import struct
import zlib

from tools.places import PROJECT

FOLDER = PROJECT / "addons/grass_field/presets/cards"
SIDE = 256  # texels; the size to which a field scales a picture (GrassSpecies.card)
FINER = 2  # as many texels are drawn along each texel, so that edges are smooth: their alpha is the share that is covered
DRAWN = SIDE * FINER
STEP = 12  # colours are rounded to multiples of this, so that pictures stay small
STALK = (0.35, 0.5, 0.2)


class Card:
	"""A picture to draw strokes and ellipses on, from back to front. Places are 0..1 from the lower left."""

	def __init__(self):
		self.texels = [None] * (DRAWN * DRAWN)

	def _each(self, left, right, low, high, visit):
		for j in range(max(int(low * DRAWN), 0), min(int(high * DRAWN) + 2, DRAWN)):
			for i in range(max(int(left * DRAWN), 0), min(int(right * DRAWN) + 2, DRAWN)):
				color = visit((i + 0.5) / DRAWN, (j + 0.5) / DRAWN)
				if color:
					self.texels[(DRAWN - 1 - j) * DRAWN + i] = color

	def texel(self, i, j):
		"""Its mean colour, or None, and the share of it that is covered."""
		seen = []
		for n in range(FINER):
			first = (j * FINER + n) * DRAWN + i * FINER
			seen += [texel for texel in self.texels[first : first + FINER] if texel]
		mean = tuple(sum(color[k] for color in seen) / len(seen) for k in range(3)) if seen else None
		return mean, len(seen) / FINER**2

	def ellipse(self, x, y, along, across, angle, color, dark=0.35):
		"""Draws an ellipse with half axes `along` and `across`, turned right by `angle` radians; its left side and foot are darker."""

		def paint(u, v):
			light = 1.0 - dark * (0.5 - 0.3 * u - 0.2 * v)
			return tuple(min(c * light, 1.0) for c in color) if u * u + v * v <= 1.0 else None

		self.shape(x, y, along, across, angle, paint)

	def shape(self, x, y, along, across, angle, paint):
		"""`paint` returns the colour at (u, v), -1..1 across and along a box as that of ellipse(), or None."""
		cosine, sine = math.cos(angle), math.sin(angle)
		reach = math.hypot(along, across)

		def visit(px, py):
			dx, dy = px - x, py - y
			v, u = (dx * sine + dy * cosine) / along, (dx * cosine - dy * sine) / across
			return paint(u, v) if abs(u) <= 1.0 and abs(v) <= 1.0 else None

		self._each(x - reach, x + reach, y - reach, y + reach, visit)

	def stroke(self, x, y, to_x, to_y, width, color):
		"""A straight line that tapers to half of its width."""
		length = max((to_x - x) ** 2 + (to_y - y) ** 2, 1e-9)

		def visit(px, py):
			t = min(max(((px - x) * (to_x - x) + (py - y) * (to_y - y)) / length, 0.0), 1.0)
			off = math.hypot(px - x - t * (to_x - x), py - y - t * (to_y - y))
			return color if off < 0.5 * width * (1.0 - 0.5 * t) else None

		pad = width
		self._each(min(x, to_x) - pad, max(x, to_x) + pad, min(y, to_y) - pad, max(y, to_y) + pad, visit)


def round_color(color):
	return tuple(min(STEP * round(255 * c / STEP), 255) for c in color)


def save(name, *cards):
	"""The pictures side by side, as PNG. Uncovered texels have the mean colour, transparent, so that smaller copies have no dark rims."""
	texels = [[[card.texel(i, j) for i in range(SIDE)] for j in range(SIDE)] for card in cards]
	seen = [color for card in texels for row in card for color, _ in row if color]
	mean = tuple(sum(color[k] for color in seen) / len(seen) for k in range(3))
	rows = bytearray()
	for j in range(SIDE):
		rows.append(0)
		for card in texels:
			for color, share in card[j]:
				rows += bytes((*round_color(color or mean), round(255 * share)))

	def chunk(kind, data):
		return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

	head = struct.pack(">IIBBBBB", SIDE * len(cards), SIDE, 8, 6, 0, 0, 0)
	png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b"")
	FOLDER.mkdir(parents=True, exist_ok=True)
	(FOLDER / f"{name}.png").write_bytes(png)


def varied(color, source, most=0.1):
	"""A colour that is a little lighter or darker."""
	light = 1.0 + source.uniform(-most, most)
	return tuple(min(c * light, 1.0) for c in color)


class Stalk:
	"""A curve from the middle of a picture's foot that nods to the right: 0 stands upright, 1 hangs down again."""

	def __init__(self, nod, top):
		self.places = [(0.5 - 0.22 * min(nod, 1.0), 0.0)]
		steps = 60
		for k in range(steps):
			angle = 2.6 * nod * (k / steps) ** 1.5
			x, y = self.places[-1]
			self.places.append((x + top / steps * math.sin(angle), y + top / steps * math.cos(angle)))

	def at(self, share):
		"""Returns the place, and the angle there from upright to the right."""
		place = share * (len(self.places) - 1)
		k = min(int(place), len(self.places) - 2)
		(x, y), (to_x, to_y) = self.places[k], self.places[k + 1]
		part = place - k
		return x + (to_x - x) * part, y + (to_y - y) * part, math.atan2(to_x - x, to_y - y)

	def draw(self, card, width, color):
		for (x, y), (to_x, to_y) in zip(self.places, self.places[1:], strict=False):
			card.stroke(x, y, to_x, to_y, width, color)


def ear(color, grains, fat, awns, nod, source):
	"""Two rows of grains up a stalk, with awns of that length (share of the card) or none."""
	card, top = Card(), 0.91 - awns
	stalk = Stalk(nod, top)
	stalk.draw(card, 0.03, varied(color, source, 0.05))
	step = (1.0 - 0.12 / top) / grains  # as a share of the stalk
	for k in range(grains):
		for side in (-1, 1):
			x, y, angle = stalk.at(0.1 + step * k + (1.0 if side > 0 else 0.5) * 0.5 * step)
			shrink = 1.0 - 0.5 * max(k / grains - 0.6, 0.0) / 0.4
			off = side * 0.5 * fat * shrink
			x, y = x + off * math.cos(angle), y - off * math.sin(angle)
			if awns:
				lean, long = angle + side * source.uniform(0.12, 0.4), awns * source.uniform(0.8, 1.1)
				end_x = min(max(x + long * math.sin(lean), 0.01), 0.99)
				card.stroke(x, y, end_x, min(y + step * top + long * math.cos(lean), 0.99), 0.009, varied(color, source))
			card.ellipse(x, y, 1.15 * step * top, 0.42 * fat * shrink, angle + side * 0.35, varied(color, source))
	x, y, angle = stalk.at(1.0)
	card.ellipse(x, y, 1.1 * step * top, 0.3 * fat, angle, varied(color, source))
	return card


def panicle(color, branches, wide, droop, grain, grains, nod, source):
	"""Branches from a stalk that spread and carry grains, so many each: a loose seed head of a grass, or the plume of reed."""
	card = Card()
	stalk = Stalk(nod, 0.97)
	stalk.draw(card, 0.018, varied(color, source, 0.05))
	for k in range(branches):
		share = k / branches
		x, y, angle = stalk.at(0.12 + 0.74 * share)
		side = 1 if k % 2 else -1
		length = wide * (1.0 - 0.75 * share) * source.uniform(0.7, 1.1)
		along, aside = 0.16 - droop * length, side * length
		x_end, y_end = x + aside * math.cos(angle) + along * math.sin(angle), y - aside * math.sin(angle) + along * math.cos(angle)
		y_end -= 0.25 * nod * length  # they hang
		card.stroke(x, y, x_end, y_end, 0.012, varied(color, source))
		for n in range(1, grains + 1):
			t = n / grains
			lean = math.atan2(x_end - x, y_end - y) + source.uniform(-0.3, 0.3)
			at_x, at_y = x + (x_end - x) * t, y + (y_end - y) * t - 0.02 * droop
			card.ellipse(at_x, at_y, grain * source.uniform(0.8, 1.2), 0.38 * grain, lean, varied(color, source, 0.18))
	x, y, angle = stalk.at(1.0)
	card.ellipse(x, y, grain, 0.38 * grain, angle, varied(color, source))
	return card


def clover_head(size, open_share, brown, source):
	"""A round head of many narrow florets, white with pink feet: from below they open, then wither brown and hang."""
	card = Card()
	card.stroke(0.5, 0.0, 0.5, 0.5, 0.045, STALK)
	rings = ((1.0, 19), (0.78, 16), (0.55, 12), (0.3, 8), (0.0, 1))
	for ring, count in rings:
		for k in range(count):
			angle = 2.0 * math.pi * (k + source.uniform(-0.3, 0.3)) / count
			turned = math.atan2(math.sin(angle), math.cos(angle))
			up = math.cos(angle) * ring  # -1 at the head's foot
			color = (0.93, 0.86 - 0.12 * source.random(), 0.84 - 0.08 * source.random())
			color = tuple(c * (0.72 + 0.28 * min(1.2 - ring + 0.5 * (up + 1.0), 1.0)) for c in color)  # round
			if up > 2.0 * open_share - 1.0:
				color = (0.62, 0.72, 0.4)  # a bud
			elif up < 2.0 * brown - 1.0:
				color, turned = (0.55, 0.43, 0.27), math.pi + 0.3 * turned
			reach = size * ring * source.uniform(0.92, 1.05)
			x, y = 0.5 + 0.84 * reach * math.sin(angle), 0.56 + 0.76 * reach * math.cos(angle)
			card.ellipse(x, y, 0.36 * size, 0.115 * size, 0.8 * turned, varied(color, source, 0.07))
	return card


def leaflet(card, x, y, size, angle, light, source):
	"""A third of a clover's leaf, its foot at (x, y): heart-shaped, with a pale chevron and veins. Grey: times the blade's colour."""

	def paint(u, v):
		wide = math.sin(math.pi * min((0.5 * v + 0.5) * 0.97 + 0.03, 1.0) ** 0.85) ** 0.62
		notch = v > 0.82 and abs(u) < 0.9 * (v - 0.82)
		if abs(u) > wide or notch:
			return None
		tone = light * (0.86 + 0.1 * u + 0.04 * v)
		veins = abs((6.0 * (v + 0.75 * abs(u))) % 1.0 - 0.5) < 0.07 and abs(u) < 0.8 * wide
		tone *= 0.82 if abs(u) > wide - 0.06 else (1.1 if abs(u) < 0.05 else (1.06 if veins else 1.0))
		pale = 0.16 * max(1.0 - abs(v + 0.9 * abs(u) - 0.3) / 0.24, 0.0)
		tone *= 1.0 + pale
		return tuple(min(tone * c, 1.0) for c in (1.0 - 0.3 * pale, 1.0, 1.0 + 0.5 * pale))

	size *= source.uniform(0.92, 1.05)
	card.shape(x + 0.52 * size * math.sin(angle), y + 0.52 * size * math.cos(angle), 0.5 * size, 0.42 * size, angle, paint)


def clover_leaves():
	"""Some leaves of three leaflets each, as they stand above a shoot, seen from above."""
	card, source = Card(), random.Random("leaves")
	places = [(0.29, 0.3, 0.72), (0.71, 0.31, 0.76), (0.3, 0.71, 0.8), (0.7, 0.7, 0.74), (0.5, 0.5, 0.92)]
	for x, y, light in places:
		turn = source.uniform(0.0, 2.1)
		for k in range(3):
			leaflet(card, x, y, 0.285, turn + 2.0944 * k + source.uniform(-0.12, 0.12), light * source.uniform(0.93, 1.05), source)
	save("clover_leaf", card)


def clover():
	source = random.Random("clover")
	heads = [(0.4, 1.0, 0.0), (0.36, 1.0, 0.28), (0.33, 0.7, 0.0), (0.24, 0.35, 0.0)]  # the last are young
	save("clover", *(clover_head(*head, source) for head in heads))


def daisy_flower(petals, wide, size, disc, missing, source):
	"""Petals around a yellow disc, from above."""
	card = Card()
	for turn in range(2):  # those behind are darker
		for k in range(petals):
			if (k + turn) % 2 or k in missing:
				continue
			angle = 2.0 * math.pi * (k + source.uniform(-0.25, 0.25)) / petals
			long = size * source.uniform(0.86, 1.04)
			shade = 0.82 + 0.18 * turn
			color = varied(tuple(c * shade for c in (0.96, 0.95, 0.92)), source, 0.05)
			x, y = 0.5 + 0.56 * long * math.sin(angle), 0.5 + 0.56 * long * math.cos(angle)
			card.ellipse(x, y, 0.46 * long, wide, angle, color, 0.25)
	for k in range(160):  # florets of the disc, in the spiral of a sunflower
		reach, angle = disc * math.sqrt((k + 0.5) / 160), 2.39996 * k
		light = 0.72 + 0.28 * (1.0 - reach / disc)
		color = varied(tuple(c * light for c in (0.95, 0.72, 0.12)), source, 0.12)
		card.ellipse(
			0.5 + reach * math.sin(angle), 0.5 + reach * math.cos(angle), 0.09 * disc + 0.008, 0.09 * disc + 0.006, 0.0, color, 0.3
		)
	return card


def daisy_bud(source):
	"""Green scales around the tips of petals that are still folded."""
	card = Card()
	for k in range(15):
		angle = 2.0 * math.pi * k / 15
		card.ellipse(0.5 + 0.13 * math.sin(angle), 0.5 + 0.13 * math.cos(angle), 0.1, 0.04, angle, varied((0.3, 0.44, 0.2), source))
	for k in range(11):
		angle = 2.0 * math.pi * k / 11
		x, y = 0.5 + 0.07 * math.sin(angle), 0.5 + 0.07 * math.cos(angle)
		card.ellipse(x, y, 0.08, 0.035, angle, varied((0.93, 0.92, 0.82), source, 0.06), 0.4)
	card.ellipse(0.5, 0.5, 0.045, 0.045, 0.0, (0.85, 0.7, 0.25), 0.4)
	return card


def daisy():
	source = random.Random("daisy")
	flowers = [
		daisy_flower(21, 0.036, 0.46, 0.115, (), source),
		daisy_flower(15, 0.052, 0.44, 0.13, (4, 5), source),
		daisy_flower(17, 0.04, 0.33, 0.105, (11,), source),
	]
	save("daisy", *flowers, daisy_bud(source))


NODS = (0.06, 0.3, 0.5, 0.75)  # of the four pictures of a seed head


def main():
	heads = {
		"wheat": lambda nod, source: ear((0.82, 0.66, 0.34), 11, 0.16, 0.0, 0.5 * nod, source),
		"barley": lambda nod, source: ear((0.85, 0.74, 0.45), 11, 0.1, 0.36, nod, source),
		"panicle": lambda nod, source: panicle((0.66, 0.55, 0.38), 20, 0.34 - 0.2 * abs(nod - 0.3), 0.1, 0.026, 7, nod, source),
		"plume": lambda nod, source: panicle((0.5, 0.38, 0.3), 38, 0.36, 0.75, 0.034, 6, 0.6 * nod, source),
	}
	for name, draw in heads.items():
		source = random.Random(name)
		save(name, *(draw(nod, source) for nod in NODS))
	clover()
	clover_leaves()
	daisy()


if __name__ == "__main__":
	main()
