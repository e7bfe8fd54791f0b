# SPDX-License-Identifier: MIT
"""How graphics drivers that are not here compile the compute passes.

Quick, for the layer `lab`: each pass becomes Metal's language, figures for one card. In full, the layer `drivers`: figures
for all cards, each pass becomes DXIL that Microsoft's validator takes, and so do the shaders that draw grass, not validated.
"""

from lab.tools import driver_figures, driver_tools
from tools.say import Failure
from tools.test import drivers
from tools.test.test_runs import Tally, noted


def parity_of_strains(tally, only):
	"""The pass by strains computes what C++ does: on Mesa's software driver, within 1e-4 of a length in 600 steps."""
	if only in (name := "drivers/strains software Vulkan moves blades as C++ does"):
		try:
			apart, farthest = driver_tools.strain_parity(driver_figures.passes()["strains"])
			print(f"    {apart:.1e} of a length apart, {farthest:.2f} from rest")
			noted(tally, name, "" if apart < 1e-4 and farthest > 0.5 else f"they are {apart} of a length apart, {farthest} from rest")
		except Failure as failure:
			noted(tally, name, str(failure))


def to_msl(tally, only):
	for label, file in driver_figures.passes().items():
		if only in (name := f"drivers/msl {label}"):
			try:
				wrong = "" if "kernel void" in driver_tools.to_msl(file) else "the translation has no kernel"
			except Failure as failure:
				wrong = str(failure)
			noted(tally, name, wrong)


def to_dxil(tally, only):
	made = {}
	for label, file in driver_figures.passes().items():
		if only in (name := f"drivers/dxil {label}"):
			try:
				made[name] = driver_tools.to_dxil(file)
			except Failure as failure:
				noted(tally, name, str(failure))
	wrong = driver_tools.wrong_dxil(made.values()) if made else {}
	for name, file in made.items():
		noted(tally, name, wrong[file])


def drawing_to_dxil(tally, only):
	"""The shaders that the renderers make for grass. The validator has no say in them: it wants the bindings and the joined signatures
	that Godot's own driver gives them, and the translator alone does not."""
	for method in drivers.METHODS:
		if only not in (name := f"drivers/dxil drawing {method}"):
			continue
		wrong = []
		shaders = drivers.drawing_shaders(method)
		for file in shaders:
			try:
				driver_tools.to_dxil(file, file.suffixes[0].removeprefix("."))
			except Failure as failure:
				wrong.append(f"{file.name}: {failure}")
		print(f"    {len(shaders)} vertex and fragment shaders")
		noted(tally, name, "; ".join(wrong) if shaders else "the engine made no shader")


def advice(notes, card, pipeline):
	"""Returns the advice for a figure that has grown."""
	there = driver_figures.made_by(notes, card, pipeline.family()).split(";")[0] or "no compiler"
	here = f"Mesa {driver_tools.mesa_version()}"
	other = f" The table is of {there}, this is {here}." if there != here else ""
	return f".{other} If it has to be: `./grass bench drivers --only {pipeline.family()} --out lab/results`"


def figures(tally, only, chosen):
	"""Checks that no figure of the pipelines `chosen` by card has grown past the margin, and that the table has exactly these pipelines."""
	notes, known = driver_figures.read()
	if only in (name := "drivers/table"):
		built = {(card, *one.key()) for card in driver_figures.CARDS for one in driver_figures.of_card(card)}
		noted(
			tally, name, "".join(f"it has {' '.join(filter(None, key))}, which is no longer built. " for key in known if key not in built)
		)
	chosen = {card: [one for one in some if only in f"drivers/{card} {one.label()}"] for card, some in chosen.items()}
	for card, made in driver_figures.compile_all({card: some for card, some in chosen.items() if some}):
		if isinstance(made, Exception):
			tally.failed.append(f"drivers/{card}: {made}")
			continue
		for pipeline, row in zip(chosen[card], made):
			wrong = driver_figures.grown(row, known.get(driver_figures.key_of(row)))
			noted(tally, f"drivers/{card} {pipeline.label()}", wrong and wrong + advice(notes, card, pipeline))


def run_quick(only):
	"""Runs the checks that take seconds, for every change."""
	driver_tools.ensure()
	tally = Tally()
	parity_of_strains(tally, only)
	to_msl(tally, only)
	figures(tally, only, {driver_figures.QUICK: driver_figures.pipelines(with_species=False)})
	return tally


def run(only):
	"""Runs all checks."""
	driver_tools.ensure()
	driver_tools.ensure_mesa()
	driver_tools.ensure_validator()
	tally = Tally()
	parity_of_strains(tally, only)
	to_msl(tally, only)
	to_dxil(tally, only)
	drawing_to_dxil(tally, only)
	figures(tally, only, {card: driver_figures.of_card(card) for card in driver_figures.CARDS})
	return tally
