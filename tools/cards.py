# SPDX-License-Identifier: MIT
"""The flowers and seed heads of the presets, drawn by numbers: `python3 -m tools.cards` writes their pictures again."""

import math
import random
import struct
import zlib

from tools.places import PROJECT

FOLDER = PROJECT / "addons/grass_field/presets/cards"
SIDE = 256  # texels; what a field keeps of a card (GrassSpecies.card)


class Card:
	"""A picture to draw strokes and ellipses on, from back to front. Places are 0..1 from the lower left."""

	def __init__(self):
		self.texels = [None] * (SIDE * SIDE)

	def _each(self, left, right, low, high, visit):
		for j in range(max(int(low * SIDE), 0), min(int(high * SIDE) + 2, SIDE)):
			for i in range(max(int(left * SIDE), 0), min(int(right * SIDE) + 2, SIDE)):
				color = visit((i + 0.5) / SIDE, (j + 0.5) / SIDE)
				if color:
					self.texels[(SIDE - 1 - j) * SIDE + i] = color

	def ellipse(self, x, y, along, across, angle, color, dark=0.35):
		"""Half axes `along` and `across`; turned from upright by `angle`, radians to the right; darker towards its left side and foot."""
		cosine, sine = math.cos(angle), math.sin(angle)
		reach = max(along, across)

		def visit(px, py):
			dx, dy = px - x, py - y
			v, u = (dx * sine + dy * cosine) / along, (dx * cosine - dy * sine) / across
			if u * u + v * v > 1.0:
				return None
			light = 1.0 - dark * (0.5 - 0.3 * u - 0.2 * v)
			return tuple(min(c * light, 1.0) for c in color)

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

	def save(self, name):
		"""As PNG. What nothing covers is transparent, in the mean colour, so that smaller copies have no dark rims."""
		seen = [texel for texel in self.texels if texel]
		mean = tuple(sum(color[k] for color in seen) / len(seen) for k in range(3))
		rows = bytearray()
		for j in range(SIDE):
			rows.append(0)
			for texel in self.texels[j * SIDE : (j + 1) * SIDE]:
				rows += bytes(round(255 * c) for c in (texel or mean)) + (b"\xff" if texel else b"\x00")

		def chunk(kind, data):
			return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

		head = struct.pack(">IIBBBBB", SIDE, SIDE, 8, 6, 0, 0, 0)
		png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b"")
		FOLDER.mkdir(parents=True, exist_ok=True)
		(FOLDER / f"{name}.png").write_bytes(png)


def varied(color, source, most=0.1):
	"""A colour somewhat lighter or darker."""
	light = 1.0 + source.uniform(-most, most)
	return tuple(min(c * light, 1.0) for c in color)


def ear(name, color, grains, fat, awns):
	"""Two rows of grains up a stalk, with awns of that length (share of the card) or none."""
	card, source = Card(), random.Random(name)
	top = 0.97 - awns
	card.stroke(0.5, 0.0, 0.5, top, 0.03, varied(color, source, 0.05))
	step = (top - 0.12) / grains
	for k in range(grains):
		y = 0.1 + step * k
		for side in (-1, 1):
			height = y + (0.5 * step if side > 0 else 0.0)
			shrink = 1.0 - 0.5 * max(k / grains - 0.6, 0.0) / 0.4
			x = 0.5 + side * 0.5 * fat * shrink
			if awns:
				lean = side * (0.05 + 0.1 * source.random())
				card.stroke(
					x, height + step, x + lean, min(height + step + awns * source.uniform(0.8, 1.1), 0.99), 0.009, varied(color, source)
				)
			card.ellipse(x, height + 0.5 * step, 1.15 * step, 0.42 * fat * shrink, side * 0.35, varied(color, source))
	card.ellipse(0.5, top, 1.1 * step, 0.3 * fat, 0.0, varied(color, source))
	card.save(name)


def panicle(name, color, branches, wide, droop, grain):
	"""Branches from a stalk that spread and carry grains: a loose seed head of a grass, or the plume of reed."""
	card, source = Card(), random.Random(name)
	card.stroke(0.5, 0.0, 0.5, 0.97, 0.018, varied(color, source, 0.05))
	for k in range(branches):
		share = k / branches
		y = 0.12 + 0.72 * share
		side = 1 if k % 2 else -1
		length = wide * (1.0 - 0.75 * share) * source.uniform(0.7, 1.1)
		x_end, y_end = 0.5 + side * length, y + 0.16 - droop * length
		card.stroke(0.5, y, x_end, y_end, 0.012, varied(color, source))
		for n in range(1, 6):
			t = n / 5.0
			x, at = 0.5 + (x_end - 0.5) * t, y + (y_end - y) * t
			lean = side * (0.5 + 1.2 * droop) + source.uniform(-0.3, 0.3)
			card.ellipse(x, at - 0.02 * droop, grain * source.uniform(0.8, 1.2), 0.38 * grain, lean, varied(color, source, 0.18))
	card.ellipse(0.5, 0.96, grain, 0.38 * grain, 0.0, varied(color, source))
	card.save(name)


def clover():
	"""A round head of many narrow florets, white with pink feet."""
	card, source = Card(), random.Random("clover")
	card.stroke(0.5, 0.0, 0.5, 0.4, 0.05, (0.35, 0.5, 0.2))
	for ring, count in ((1.0, 17), (0.75, 14), (0.5, 10), (0.25, 6)):
		for k in range(count):
			angle = math.pi * (2.0 * (k + 0.5 * source.random()) / count)
			x, y = 0.5 + 0.27 * ring * math.sin(angle), 0.52 + 0.24 * ring * math.cos(angle)
			pink = 0.25 * max(-math.cos(angle), 0.0) + 0.08 * source.random()
			card.ellipse(
				x,
				y,
				0.15,
				0.052,
				0.75 * angle if angle < math.pi else 0.75 * (angle - 2.0 * math.pi),
				varied((0.95, 0.93 - pink, 0.9 - 0.6 * pink), source, 0.06),
			)
	card.save("clover")


def daisy():
	"""Narrow petals around a yellow disc, seen somewhat from the side."""
	card, source = Card(), random.Random("daisy")
	card.stroke(0.5, 0.0, 0.5, 0.5, 0.035, (0.35, 0.5, 0.2))
	for k in range(17):
		angle = 2.0 * math.pi * (k + source.uniform(-0.2, 0.2)) / 17
		long = source.uniform(0.34, 0.42)
		x, y = 0.5 + 0.5 * long * math.sin(angle) * 1.15, 0.52 + 0.32 * long * math.cos(angle)
		turned = math.atan2(1.15 * math.sin(angle), 0.64 * math.cos(angle))
		card.ellipse(
			x,
			y,
			0.5 * long * math.hypot(1.15 * math.sin(angle), 0.64 * math.cos(angle)) + 0.03,
			0.045,
			turned,
			varied((0.96, 0.95, 0.92), source, 0.05),
			0.25,
		)
	card.ellipse(0.5, 0.53, 0.085, 0.12, 0.0, (0.9, 0.68, 0.1), 0.5)
	card.save("daisy")


def main():
	ear("wheat", (0.82, 0.66, 0.34), 11, 0.16, 0.0)
	ear("barley", (0.85, 0.74, 0.45), 11, 0.1, 0.36)
	panicle("panicle", (0.66, 0.55, 0.38), 16, 0.34, 0.1, 0.035)
	panicle("plume", (0.5, 0.38, 0.3), 34, 0.36, 0.75, 0.04)
	clover()
	daisy()


if __name__ == "__main__":
	main()
