# SPDX-License-Identifier: MIT
"""The parts of `./grass bench`, each a process that writes one table: how it is started, how long it takes, which pages show it."""

from dataclasses import dataclass

from tools.say import Failure

CARD, HERE = "card", "here"  # a card measures the part, which may be elsewhere; or this machine's processor does
SIZE = "1920x1080"


@dataclass
class Part:
	name: str  # of its table, NAME.csv, and of its record, NAME.json
	seconds: int  # that it took, or should take, on a card of a data centre; once a set has it, that says so
	pages: tuple = ("README",)  # of lab/results, which show its table; none: only on request
	where: str = CARD
	scene: str = ""  # of lab/project/bench: the key in bench.gd, if it is not the name
	program: str = ""  # instead of the scene: of build/bench, with arguments, and more after ";"; what they print is the table
	method: str = "forward_plus"  # of rendering; or headless
	size: str = SIZE
	flags: str = ""  # for the engine
	takes: str = ""  # of spirv, packs, and quick: programs that know a sample
	cache: str = "shared"  # of shaders: shared by all parts; empty; filled by the part before

	def key(self):
		return self.scene or self.name


FIXED = "--fixed-fps 60"  # a tick in each frame, so that a slow frame has no more ticks than a quick one
# In the order in which a card is asked: what the page's first lines need comes first.
PARTS = (
	Part("paper_memory", 6, ("README", "paper"), size="640x360"),
	Part("paper_rivals", 80, ("README", "paper")),
	Part("meadow", 30, ("README",)),
	Part("draw", 20),
	Part("draw_mobile", 15, scene="draw", method="mobile"),
	Part("kernel", 110, size="640x360", takes="spirv"),
	Part("detail", 40),
	Part("movers", 25, flags=FIXED),
	Part("rest", 20),
	Part("town", 60, (), flags=FIXED),
	Part("touch", 20, (), flags=FIXED, size="320x180"),
	Part("room", 20, (), size="320x180"),
	Part("paper_passes", 25, ("paper",)),
	Part("limits", 10),
	Part("levels", 40, flags="--xr-mode on"),
	Part("paper_table1", 85, ("paper",)),
	Part("paper_awake", 50, ("paper",), size="640x360"),
	Part("paper_tiles", 50, ("paper",), size="640x360"),
	Part("paper_lists", 25, ("paper",), size="640x360", takes="spirv"),
	Part("cpu", 70, flags=FIXED, size="640x360"),
	Part("hitch_cold", 45, scene="hitch", cache="empty"),
	Part("hitch_warm", 35, scene="hitch", cache="filled"),
	Part("change", 20, size="640x360"),
	Part("accuracy", 180, (), size="640x360", takes="spirv packs"),  # all knots of all steps: 150 MB to carry back
	Part("forces", 40, ()),
	Part("questions", 100, ()),
	Part("species", 60, ()),
	Part("flops", 2, where=HERE, program="bench_flops"),
	Part("crowd", 60, where=HERE, method="headless"),
	Part("simulate", 30, where=HERE, method="headless"),
	Part("sleep", 20, where=HERE, method="headless", flags=FIXED),
	Part("awake", 200, where=HERE, method="headless", flags=FIXED),
	Part("speed", 40, ("solver",), where=HERE, program="bench_solver speed"),
	Part("accuracy_cpu", 600, ("accuracy",), where=HERE, program="accuracy_8; accuracy_16; accuracy_32", takes="quick"),
)
BY_NAME = {part.name: part for part in PARTS}


def chosen(only=""):
	"""Returns the parts that `only` names, with commas, `card` and `here` for all of that place; without it those that pages show."""
	if not only:
		return [part for part in PARTS if part.pages]
	found = []
	for word in only.split(","):
		if word not in BY_NAME and word not in (CARD, HERE):
			raise Failure(f"--only takes {CARD}, {HERE} and these, with commas between them: {', '.join(BY_NAME)}.", 2)
		found += [part for part in PARTS if part.name == word or (part.where == word and part.pages)]
	return [part for part in PARTS if part in found]


def listing(times):
	"""Returns the lines of the pack's file `parts`, which all.sh reads. `times`: seconds that parts took, by name."""
	lines = []
	for part in PARTS:
		if part.where == CARD and part.pages:
			seconds = round(times.get(part.name, part.seconds))
			takes = ",".join(part.takes.split()) or "-"
			lines.append(f"{part.name} {part.key()} {seconds} {part.method} {part.size} {part.cache} {takes} {part.flags}".rstrip())
	return lines
