# SPDX-License-Identifier: MIT
"""Small SVG plots: marks and lines between axes that are linear or logarithmic.

Why our own: the plots are committed, so the same rows must make the same bytes on every machine, and matplotlib brings numpy and nine more
packages for a hundred lines.
"""

import math

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 900, 560, 80, 60, 30, 60
TICKS = (1, 2, 5)


def number(value):
	return f"{value:,.0f}" if value >= 1000 else f"{value:g}"


class Axis:
	"""The places of values between `begin` and `end`, in pixels."""

	def __init__(self, values, begin, end, log=False, part=1):
		"""part: of a power of ten at which a logarithmic axis may end."""
		self.begin, self.end, self.log = begin, end, log
		if log:
			self.low = math.floor(math.log10(min(values)) * part) / part
			self.high = max(math.ceil(math.log10(max(values)) * part + 1e-9) / part, self.low + 1 / part)
		else:
			self.low, self.high = 0.0, max(max(values, default=1.0) * 1.05, 1e-9)

	def at(self, value):
		place = math.log10(value) if self.log else value
		return self.begin + (place - self.low) / (self.high - self.low) * (self.end - self.begin)

	def ticks(self):
		if self.log:
			powers = range(math.floor(self.low), math.ceil(self.high) + 1)
			steps = TICKS if self.high - self.low < 3.5 else (1,)
			found = [step * 10.0**power for power in powers for step in steps]
			return [value for value in found if self.low - 1e-9 <= math.log10(value) <= self.high + 1e-9]
		rough = self.high / 6
		power = 10 ** math.floor(math.log10(rough))
		step = next(step for step in (1, 2, 5, 10) if step * power >= rough) * power
		return [step * i for i in range(int(self.high / step) + 1)]


class Plot:
	def __init__(self, title, across, up, xs, ys, log_x=False, log_y=False):
		self.x = Axis(xs, LEFT, WIDTH - RIGHT, log_x, part=4)
		self.y = Axis(ys, HEIGHT - BOTTOM, TOP, log_y, part=2)
		self.parts = [
			f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13" fill="#222">',
			f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/><text x="{LEFT}" y="28" font-size="16">{title}</text>',
		]
		for value in self.y.ticks():
			y = self.y.at(value)
			self.parts.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#ddd"/>')
			self.text(LEFT - 8, y + 4, number(value), "end")
		for value in self.x.ticks():
			x = self.x.at(value)
			self.parts.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#eee"/>')
			self.text(x, HEIGHT - BOTTOM + 18, number(value), "middle")
		self.text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, across, "middle")
		middle = (TOP + HEIGHT - BOTTOM) / 2
		if up:
			self.parts.append(f'<text transform="translate(20 {middle}) rotate(-90)" text-anchor="middle">{up}</text>')

	def at(self, x, y):
		return self.x.at(x), self.y.at(y)

	def text(self, x, y, text, anchor="start", size=13, color="#222"):
		halo = 'stroke="#fff" stroke-width="3" paint-order="stroke"'
		self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{color}" {halo}>{text}</text>')

	def line(self, points, color="#555", dashes="", width=1.5):
		places = " ".join(f"{x:.1f},{y:.1f}" for x, y in (self.at(*point) for point in points))
		dash = f' stroke-dasharray="{dashes}"' if dashes else ""
		self.parts.append(f'<polyline points="{places}" fill="none" stroke="{color}" stroke-width="{width}"{dash}/>')

	def mark(self, x, y, color, radius=4.5, full=True, square=False):
		(x, y), fill = self.at(x, y), color if full else "#fff"
		look = f'fill="{fill}" stroke="{color}" stroke-width="1.3" fill-opacity="0.75"'
		if square:
			side = 1.8 * radius
			self.parts.append(f'<rect x="{x - side / 2:.1f}" y="{y - side / 2:.1f}" width="{side:.1f}" height="{side:.1f}" {look}/>')
		else:
			self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" {look}/>')

	def legend(self, items, rest=""):
		"""items: (text, color)."""
		x = LEFT
		for text, color in items:
			self.parts.append(f'<circle cx="{x + 6}" cy="45" r="4.5" fill="{color}"/>')
			self.text(x + 15, 49, text)
			x += 30 + 9 * len(text)
		self.text(x, 49, rest, size=11, color="#555")

	def svg(self):
		return "\n".join([*self.parts, "</svg>\n"])
