# SPDX-License-Identifier: MIT
"""`./grass bench accuracy`: run time against error of both solver methods, as one CSV and one SVG plot for each error."""

import csv
import datetime
import math
import pathlib
import platform
import subprocess

from tools import build
from tools.places import BUILD, OUT, ROOT
from tools.say import Failure, progress, say

KNOTS = (8, 16, 32)
COLUMNS = ("method", "precision", "knots", "substeps", "iterations", "ms", "error", "value")
ERRORS = {
	"static_1": "Sag under an even load of Γ = 1, against the elastica (share)",
	"static_5": "Sag under an even load of Γ = 5, against the elastica (share)",
	"frequency": "First frequency at 2.5 Hz (share)",
	"amplitude_lost": "Amplitude lost in a period, undamped (share)",
	"transient": "Way of all knots in a second after release, against the converged rod (RMS, blade lengths)",
	"sphere_sweep": "Way of all knots under a ball at 5 m/s, against the converged rod (RMS, blade lengths)",
}
COLORS = {"DIRECT": "#1b7f4b", "PBD": "#c2571a"}
LEAST = 1e-5  # errors below this are drawn here: a logarithm knows no zero
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 900, 560, 80, 60, 30, 60


def run(out, is_quick):
	build.scons("accuracy")
	folder = pathlib.Path(out or OUT / "bench") / "accuracy"
	folder.mkdir(parents=True, exist_ok=True)
	rows = []
	for knots in KNOTS:
		with progress(f"Solving with {knots} knots", every=10):
			result = subprocess.run([BUILD / f"bench/accuracy_{knots}", *(["--quick"] if is_quick else [])], capture_output=True, text=True)
		if result.returncode:
			raise Failure(f"accuracy_{knots} ended with code {result.returncode}:\n{result.stderr}")
		rows += [dict(zip(COLUMNS, line.split(","))) for line in result.stdout.splitlines()]
	write_table(folder / "accuracy.csv", rows)
	for error, title in ERRORS.items():
		(folder / f"{error}.svg").write_text(plot(title, [row for row in rows if row["error"] == error]))
	say(f"Tables and plots: {folder}")


def processor():
	try:
		with open("/proc/cpuinfo", encoding="utf-8") as info:
			return next(line.split(":", 1)[1].strip() for line in info if line.startswith("model name"))
	except (OSError, StopIteration):
		return platform.processor() or platform.machine()


def commit():
	result = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True)
	return result.stdout.strip() or "unknown"


def write_table(path, rows):
	with open(path, "w", encoding="utf-8", newline="") as file:
		file.write(f"# {processor()}, one core; commit {commit()}; {datetime.date.today()}; ./grass bench accuracy\n")
		file.write("# ms: a frame (1/60 s) of 65,536 swinging blades\n")
		writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
		writer.writeheader()
		writer.writerows(rows)


def pareto(points):
	"""The points that no other is both faster and (by a twentieth, since timing is noisy) truer than, by rising time."""
	front = []
	for point in sorted(points):
		if not front or point[1] < 0.95 * front[-1][1]:
			front.append(point)
	return front


def plot(title, rows):
	"""Run time to the right, error upwards, both by powers of ten; the Pareto front as a line."""
	points = [(float(row["ms"]), max(float(row["value"]), LEAST), row) for row in rows]
	span_x = (math.floor(math.log10(min(p[0] for p in points)) * 4) / 4, math.ceil(math.log10(max(p[0] for p in points)) * 4) / 4)
	span_y = (math.floor(math.log10(min(p[1] for p in points))), math.ceil(math.log10(max(p[1] for p in points)) + 1e-9))

	def at(ms, error):
		x = LEFT + (math.log10(ms) - span_x[0]) / (span_x[1] - span_x[0]) * (WIDTH - LEFT - RIGHT)
		y = HEIGHT - BOTTOM - (math.log10(error) - span_y[0]) / max(span_y[1] - span_y[0], 1) * (HEIGHT - TOP - BOTTOM)
		return x, y

	parts = [
		f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13" fill="#222">',
		f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/><text x="{LEFT}" y="28" font-size="16">{title}</text>',
	]
	parts += axes(at, span_x, span_y)
	front = pareto([(ms, error, index) for index, (ms, error, _) in enumerate(points)])
	line = " ".join(f"{x:.1f},{y:.1f}" for x, y in (at(ms, error) for ms, error, _ in front))
	parts.append(f'<polyline points="{line}" fill="none" stroke="#555" stroke-width="1.5" stroke-dasharray="5 4"/>')
	parts += [mark(*at(ms, error), row) for ms, error, row in points]
	parts += labels([(*at(ms, error), points[index][2]) for ms, error, index in front])
	return "\n".join([*parts, legend(), "</svg>\n"])


def axes(at, span_x, span_y):
	left, right = 10 ** span_x[0], 10 ** span_x[1]
	for power in range(span_y[0], span_y[1] + 1):
		(x1, y), (x2, _) = at(left, 10.0**power), at(right, 10.0**power)
		yield f'<line x1="{x1:.1f}" y1="{y:.1f}" x2="{x2:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
		yield f'<text x="{x1 - 8:.1f}" y="{y + 4:.1f}" text-anchor="end">{10.0**power:g}</text>'
	for ms in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000):
		if left <= ms <= right:
			(x, bottom), (_, top) = at(ms, 10.0 ** span_y[0]), at(ms, 10.0 ** span_y[1])
			yield f'<line x1="{x:.1f}" y1="{bottom:.1f}" x2="{x:.1f}" y2="{top:.1f}" stroke="#eee"/>'
			yield f'<text x="{x:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{ms}</text>'
	yield f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 14}" text-anchor="middle">ms for a frame of 65,536 blades, one core</text>'


def mark(x, y, row):
	"""Size by knots, full for float."""
	color, radius = COLORS[row["method"]], {8: 3, 16: 4.5, 32: 6}[int(row["knots"])]
	fill = color if row["precision"] == "CPU float" else "#fff"
	return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill}" stroke="{color}" stroke-width="1.3" fill-opacity="0.75"/>'


def labels(front):
	lowest = -1e9
	for x, y, row in front:
		lowest = max(lowest + 15, y - 8)
		text = f'{row["method"]} {row["knots"]} knots, {row["substeps"]} × {row["iterations"]}'
		anchor = "end" if x > WIDTH * 0.72 else "start"
		yield f'<text x="{x + (-9 if anchor == "end" else 9):.1f}" y="{lowest:.1f}" text-anchor="{anchor}" font-size="11">{text}</text>'


def legend():
	x, items = LEFT, []
	for method, color in COLORS.items():
		items.append(f'<circle cx="{x + 6}" cy="45" r="4.5" fill="{color}"/><text x="{x + 15}" y="49">{method}</text>')
		x += 85
	rest = "filled: float, 8 lanes · hollow: double · size: 8, 16, 32 knots · dashed: Pareto front (steps a frame × iterations)"
	items.append(f'<text x="{x}" y="49" fill="#555" font-size="11">{rest}</text>')
	return "".join(items)
