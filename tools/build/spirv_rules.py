# SPDX-License-Identifier: MIT
"""The demands that a compute pass may make, so that each of Godot's drivers accepts it. The build refuses a pass that demands more.

docs/internals/drivers.md shows the same table; tests/passes/rules/ has a pass that breaks each rule.
"""

from dataclasses import dataclass
from typing import Callable

VULKAN, D3D12, METAL = "Vulkan", "Direct3D 12", "Metal"


@dataclass(frozen=True)
class Rule:
	name: str
	allowed: str
	driver: str  # that asks for it
	reason: str
	found: Callable  # takes a spirv.Module; returns what is too much, in words, or ""


def others(known, of):
	"""Returns a check that refuses names that are not `known`. `of` returns a module's names."""
	return lambda module: ", ".join(sorted({name for name in of(module) if name not in known}))


def at_most(limit, of):
	"""Returns a check that refuses a number above `limit`."""
	return lambda module: str(of(module)) if of(module) > limit else ""


def count(*kinds):
	return lambda module: sum(binding.count for binding in module.bindings.values() if binding.kind in kinds)


def written(module):
	return sum(binding.count for binding in module.bindings.values() if binding.is_written)


def buffers(module):
	return count("buffer", "uniforms")(module) + (module.pushed > 0)


def threads(module):
	return module.group[0] * module.group[1] * module.group[2]


def read_images(module):
	images = (binding for binding in module.bindings.values() if binding.kind == "image" and binding.is_read)
	return [f"{image.format}, read" for image in images if image.format not in ("r32f", "r32i", "r32ui")]


RULES = (
	Rule(
		"SPIR-V version", "1.3 at most", VULKAN, "a driver of Vulkan 1.1 takes no newer one",
		lambda module: ".".join(map(str, module.version)) if module.version > (1, 3) else "",
	),
	Rule(
		"capability", "Shader, ImageQuery", VULKAN, "all others are features that a driver may lack",
		others(("Shader", "ImageQuery"), lambda module: module.capabilities),
	),
	Rule("extension", "none", VULKAN, "a driver may lack it", others((), lambda module: module.extensions)),
	Rule(
		"built-in", "WorkgroupId, WorkgroupSize, LocalInvocationId, LocalInvocationIndex, GlobalInvocationId", D3D12,
		"others, such as NumWorkgroups, become a constant buffer that Godot's root signature shows to no compute pass",
		others(
			("WorkgroupId", "WorkgroupSize", "LocalInvocationId", "LocalInvocationIndex", "GlobalInvocationId"),
			lambda module: module.built_ins,
		),
	),
	Rule(
		"specialization constant", "bool, uint, float", D3D12, "Godot's translator to DXIL ends on any other type, such as int",
		others(("bool", "uint", "float"), lambda module: module.constants.values()),
	),
	Rule(
		"image that is read", "r32f, r32i, r32ui; any image may be written", D3D12, "a card need not be able to load other formats",
		others((), read_images),
	),
	Rule(
		"buffers and images that are written", "8 at most", D3D12,
		"the unordered access views that feature level 11.0 has", at_most(8, written),
	),
	Rule(
		"buffers", "31 at most, push constants count as one", METAL,
		"as many as a kernel has. Vulkan promises 4 storage buffers, Mesa's drivers have millions", at_most(31, buffers),
	),
	Rule("storage images", "4 at most", VULKAN, "what every driver has", at_most(4, count("image"))),
	Rule("textures", "16 at most", VULKAN, "what every driver has", at_most(16, count("texture", "plain texture"))),
	Rule("samplers", "16 at most", VULKAN, "what every driver has", at_most(16, count("texture", "sampler"))),
	Rule(
		"shared memory", "16,384 bytes at most", VULKAN, "what every driver has; Direct3D 12 and Metal have 32,768",
		at_most(16384, lambda module: module.shared),
	),
	Rule("push constants", "128 bytes at most", VULKAN, "what every driver has", at_most(128, lambda module: module.pushed)),
	Rule(
		"threads in a workgroup", "128 at most", VULKAN, "what every driver has; Direct3D 12 and Metal have 1,024",
		at_most(128, threads),
	),
)  # fmt: skip


def broken(module):
	"""Returns the demands of a pass that are not allowed, as texts that begin with the rule's name."""
	found = ((rule, rule.found(module)) for rule in RULES)
	return [f"{rule.name}: {what} (allowed: {rule.allowed}). {rule.driver}: {rule.reason}." for rule, what in found if what]
