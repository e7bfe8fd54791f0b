# SPDX-License-Identifier: MIT
"""The layer `passes`: each rule of the build refuses the pass in tests/passes/rules that breaks it, and no other rule does.

That our own passes break none the build has checked (tools/build/spirv_rules.py).
"""

from tools.build import embed, spirv, spirv_rules
from tools.fetch import machine
from tools.places import BUILD, ROOT
from tools.test.test_runs import Tally, noted

BREAKING = ROOT / "tests/passes/rules"  # a pass for each rule


def file_of(rule):
	return BREAKING / f"{rule.name.lower().replace(' ', '_').replace('-', '')}.glsl"


def refused_for(source):
	"""Returns names of the rules that a pass breaks."""
	target = "vulkan1.2" if "target vulkan1.2" in source.read_text() else "vulkan1.1"
	made = BUILD / "pass_rules" / f"{source.stem}.spv"
	return [
		text.split(":")[0]
		for text in spirv_rules.broken(spirv.read(embed.compile_shader(source, [], machine.glslang(), made, target=target)))
	]


def run(only):
	tally = Tally()
	for rule in spirv_rules.RULES:
		if only in (name := f"passes/{rule.name}"):
			found = refused_for(file_of(rule))
			noted(tally, name, "" if found == [rule.name] else f"{file_of(rule).name} is refused for: {', '.join(found) or 'nothing'}")
	if only in (name := "passes/that break rules"):
		spare = sorted({file.name for file in BREAKING.iterdir()} - {file_of(rule).name for rule in spirv_rules.RULES})
		noted(tally, name, spare and f"no rule has the name of {', '.join(spare)}")
	return tally
