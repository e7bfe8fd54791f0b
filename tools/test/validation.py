# SPDX-License-Identifier: MIT
"""The layer `validation`: a scene under Vulkan's validation layer, on software Vulkan.

A message that comes with fields and not without them fails, but for those in FALSE_ALARM. The scene runs without fields only if it brought
other messages with them.
"""

import collections
import re

from tools.fetch import machine
from tools.places import BUILD, PROJECT
from tools.run import engine
from tools.say import Failure, progress, say
from tools.test import drivers

SCENE = "res://tests/validation/scene.tscn"
METHODS = ("forward_plus", "mobile")
FOLDER = BUILD / "validation"  # the layer's settings and messages
LIMIT = 3600  # seconds, of one run
SETTINGS = """\
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
khronos_validation.log_filename = {log}
khronos_validation.report_flags = error,warn
khronos_validation.enable_message_limit = false
khronos_validation.validate_sync = true
khronos_validation.syncval_shader_accesses_heuristic = true
khronos_validation.syncval_message_extra_properties = true
"""
# Properties of a message, and its binding: the layer does not know which slots a dispatch writes, see
# docs/history/0019-dispatches-without-barriers.md.
FALSE_ALARM = {
	"hazard_type": "WRITE_AFTER_WRITE", "command": "vkCmdDispatch", "prior_command": "vkCmdDispatch", "write_barriers": "0",
	"prior_access": "VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT(VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT)",
}  # fmt: skip
OWN_SLOTS = ("4", "5", "7", "8", "9", "13", "15")


def is_false_alarm(message):
	properties = dict(re.findall(r"^(\w+) = (.*)$", message, re.MULTILINE))
	return FALSE_ALARM.items() <= properties.items() and properties.get("descriptor_binding") in OWN_SLOTS


def pipeline_of(message):
	return "".join(re.findall(r"VkPipeline (0x[0-9a-f]+)", message)[-1:])


def kind(message):
	"""Returns the message without the parts that differ from run to run: handles, numbers of commands."""
	return re.sub(r"0x[0-9a-f]+|^\w+_no = .*$", "#", message.split("\nObjects:")[0], flags=re.MULTILINE)


def judge(with_fields, without):
	"""Returns (kinds of messages that appear only with fields, with their counts; number of false alarms)."""
	# Only for pipelines that are known to write twists: cull has bindings with the same numbers.
	simulate = {pipeline_of(message) for message in with_fields if "descriptor_binding = 13\n" in message}
	alarms = [message for message in with_fields if is_false_alarm(message) and pipeline_of(message) in simulate]
	engine_s_own = set(map(kind, without))
	left = collections.Counter(map(kind, with_fields)) - collections.Counter(map(kind, alarms))
	return collections.Counter({text: count for text, count in left.items() if text not in engine_s_own}), len(alarms)


def layer(only, tally):
	"""Adds the results of the methods that have `only` in their test's name."""
	lazy = {**drivers.build(), drivers.LAZY: "all"}  # the engine makes many pipelines that the scene does not draw with
	for method in METHODS:
		name = f"validation/{method}"
		if only not in name:
			continue
		try:
			with_fields = messages(method, lazy, "--field")
			found, alarms = judge(with_fields, [])
			if found:  # the engine's own do not count
				found, alarms = judge(with_fields, messages(method, lazy))
		except Failure as failure:
			tally.failed.append(f"{name}: {failure}")
			continue
		say(f"{name}: {found.total()} messages of {len(found)} kinds with fields only; {alarms} known false alarms")
		for text, count in found.items():
			print(f"{count} times: {text}")
		if found:
			tally.failed.append(f"{name}: messages that only fields bring, all of them in {FOLDER}")
		else:
			tally.passed += 1
		print(f"{'fail' if found else 'pass':>6} {name}", flush=True)
	return tally


def messages(method, below, *arguments):
	"""Returns the messages that the layer wrote while the scene ran. `below`: environment additions that put a layer of ours below it."""
	FOLDER.mkdir(parents=True, exist_ok=True)
	name = "_".join([method, *(argument.strip("-") for argument in arguments)])
	log, settings = FOLDER / f"{name}.txt", FOLDER / "vk_layer_settings.txt"
	log.unlink(missing_ok=True)
	settings.write_text(SETTINGS.format(log=log))
	layers = {
		**below, "VK_LAYER_PATH": f"{machine.validation_layer()}:{below['VK_LAYER_PATH']}",
		"VK_INSTANCE_LAYERS": f"VK_LAYER_KHRONOS_validation:{below['VK_INSTANCE_LAYERS']}", "VK_LAYER_SETTINGS_PATH": str(settings),
	}  # fmt: skip
	output = []
	with engine.window(method, "320x180", software=True) as (command, environment), progress(f"Running the scene: {name}", every=10):
		everything = [*command, "--path", str(PROJECT), "--fixed-fps", "60", SCENE, "--", *arguments]
		code = engine.run(everything, {**environment, **layers}, output.append, LIMIT)
	told = [line for line in output if "GRASS-VALIDATION" in line]
	if code or "GRASS-VALIDATION done" not in told:
		raise Failure(f"The scene ended with code {code}:\n" + "\n".join(output[-20:]))
	print("\n".join(told[:-1]))
	if not log.exists():
		raise Failure("The validation layer wrote nothing: was it loaded? The engine said:\n" + "\n".join(output[-20:]))
	return re.split(r"^(?=Validation )", log.read_text(), flags=re.MULTILINE)[1:]
