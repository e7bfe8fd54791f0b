# SPDX-License-Identifier: MIT
"""Plays the problems with our programs and with others' own code, and writes FOLDER/rods.csv and FOLDER/rods.svg.

compare.py FOLDER NOTE PROGRAM...: `./grass bench rods` gives all of them. Others play through the adapters of cosseratbench, which choose
steps, damping and stiffness for them.
"""

import csv
import pathlib
import subprocess
import sys
import time
from importlib.metadata import version

import numpy as np
import picture
import problem
from cosseratbench.scenario import EndCondition, Material, Rod, Scenario
from cosseratbench.solver import Diverged
from cosseratbench.solvers.mujoco import MuJoCoSolver
from cosseratbench.solvers.pyelastica import PyElasticaSolver

COLUMNS = ("program", "elements", "steps_a_second", "us_a_step", "us_a_frame", "sag_1", "sag_5", "period", "amplitude_lost", "way")
ELEMENTS = (7, 15)  # those of the programs with 8 and 16 knots
OTHERS = {f"PyElastica {version('pyelastica')}": PyElasticaSolver, f"MuJoCo {version('mujoco')}, cable": MuJoCoSolver}
REFERENCE = "the reference with one function less"


def row(program, elements, rate, us_a_step, errors):
	"""`us_a_step`: microseconds; None where it diverges."""
	values = {"program": program, "elements": elements, "steps_a_second": round(rate)}
	if us_a_step:
		values |= {"us_a_step": f"{us_a_step:.4g}", "us_a_frame": f"{us_a_step * rate / problem.FRAMES_A_SECOND:.4g}"}
	return values | {name: f"{value:.3g}" for name, value in errors.items()}


def ours(programs, reference):
	"""Rows of our own programs."""
	angles = " ".join(f"{angle:.9g}" for angle in reference.angles(np.linspace(0.0, 1.0, 1001)))
	given = f"{problem.RELEASED_FROM} {problem.SECONDS} {angles}"
	for program in programs:
		said = subprocess.run([program], input=given, capture_output=True, text=True, check=True).stdout
		errors = {}
		for line in csv.reader(said.splitlines()):
			(name, elements, rate, us_a_step, kind, load), tips = line[:6], np.array(line[6:], float).reshape(-1, 2)
			found = errors.setdefault((f"GrassField, {name}", int(elements), int(rate), float(us_a_step)), {})
			if kind == "sag":
				found[f"sag_{float(load):g}"] = tips[-1][1] / reference.sags[float(load)] - 1.0
			else:
				found |= problem.errors_of_release(tips, reference)
		for what, found in errors.items():
			yield row(*what, found)


def scenario(nodes, load, seconds):
	material = Material(problem.YOUNGS_MODULUS, problem.YOUNGS_MODULUS / 3.0, problem.DENSITY)
	places = tuple(tuple(float(part) for part in node * problem.LENGTH) for node in nodes)
	rod = Rod(places, problem.RADIUS, material, start=EndCondition.CLAMPED)
	pull = (0.0, problem.gravity(load), 0.0)
	return Scenario((rod,), seconds, pull, quasi_static=load > 0.0, self_contact=False)


def played(solver, nodes, load, seconds, frames):
	"""Returns (tips after each frame in lengths, seconds of a processor), or None where it diverges."""
	elements, task = len(nodes) - 1, scenario(nodes, load, seconds)
	try:
		solver.run(scenario(nodes, load, 1e-3 * seconds), n_elements=elements, n_frames=2)  # what it compiles at first does not count
		before = time.process_time()
		path = solver.run(task, n_elements=elements, n_frames=frames + 1).positions[0]
		took = time.process_time() - before
	except Diverged:
		return None
	tips = path[1:, -1, :2] / problem.LENGTH
	return (tips, took) if np.isfinite(tips).all() else None


def others(reference):
	"""Rows of other programs; without errors where they diverge."""
	for name, made in OTHERS.items():
		for elements in ELEMENTS:
			solver, errors, shape = made(), {}, reference.shape(elements)
			straight = np.linspace([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], elements + 1)
			for load in problem.SAGS:
				if hung := played(solver, straight, load, problem.SAG_SECONDS, 1):
					errors[f"sag_{load:g}"] = hung[0][-1][1] / reference.sags[load] - 1.0
			swung = played(solver, shape, 0.0, problem.SECONDS, problem.FRAMES)
			if swung:
				errors |= problem.errors_of_release(swung[0], reference)
			told = solver.settings(scenario(shape, 0.0, problem.SECONDS), n_elements=elements, n_frames=problem.FRAMES + 1)
			step = told["time_step"]
			yield row(name, elements, 1.0 / step, swung and 1e6 * swung[1] * step / problem.SECONDS, errors)


def main(folder, note, *programs):
	reference, coarser = problem.Reference(), problem.Reference(problem.FUNCTIONS - 1)
	rows = [{"program": REFERENCE} | {name: f"{value:.3g}" for name, value in problem.errors_of_release(coarser.tips, reference).items()}]
	for found in (*ours(programs, reference), *others(reference)):
		rows.append(found)
		print(*found.values(), flush=True)
	with open(pathlib.Path(folder, "rods.csv"), "w", encoding="utf-8", newline="") as file:
		file.write(f"# {note}\n")
		writer = csv.DictWriter(file, COLUMNS, restval="", lineterminator="\n")
		writer.writeheader()
		writer.writerows(rows)
	picture.draw(rows, pathlib.Path(folder, "rods.svg"))


main(*sys.argv[1:])
