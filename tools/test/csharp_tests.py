# SPDX-License-Identifier: MIT
"""The layer `csharp`: the wrappers offer what the library registers, compile, and do what they say.

No .NET SDK is in the package sources that the tests reach, so Mono's compiler (C# 7, from Debian) compiles them against
tests/csharp/godot_sharp.cs, which states the part of GodotSharp that they use. No engine with C# runs them.
"""

import json
import subprocess

from tools.csharp import reference, wrappers
from tools.fetch import machine, settle
from tools.fetch.roots import CSHARP
from tools.pages import snippets
from tools.places import BUILD, PROJECT, ROOT
from tools.run import engine
from tools.say import Failure
from tools.test.test_runs import Tally, noted

HERE = ROOT / "tests/csharp"
MADE = BUILD / "csharp"
WRAPPERS = MADE / "wrappers"
LIMIT = 300  # seconds
NO_COMMENT = "1591"  # a public member without one
FLAGS = ("-langversion:7.2", "-warnaserror", f"-nowarn:{NO_COMMENT}", "-nologo", "-noconfig", "-r:System.dll", "-r:System.Core.dll")


def mono(program):
	"""Returns the command that runs a C# program, one of the fetched compiler's by its name. None if it is not there yet."""
	place = CSHARP.place
	if not (place / "usr/bin/mono-sgen").exists():
		return None
	path = place / "usr/lib/mono/4.5" / program if program == "mcs.exe" else program
	return [*settle.through_loader(place, place / "usr/bin/mono-sgen"), str(path)]


COMPILER = (lambda: mono("mcs.exe"), ("mono-mcs",), CSHARP)


def run(command):
	"""Returns (exit code, output) of a C# program."""
	libraries = CSHARP.place / "usr/lib"
	configuration = (CSHARP.place / "etc/mono/config").read_text().replace("$mono_libdir", str(libraries))  # would name the machine's own
	(MADE / "mono").mkdir(exist_ok=True)
	(MADE / "mono/config").write_text(configuration)
	environment = {"MONO_PATH": str(libraries / "mono/4.5"), "MONO_CFG_DIR": str(MADE), "LC_ALL": "C.UTF-8", "HOME": str(MADE)}
	result = subprocess.run(command, cwd=MADE, env=environment, capture_output=True, text=True, timeout=LIMIT)
	return result.returncode, (result.stdout + result.stderr).strip()


def compile(out, *sources):
	"""Compiles C# sources with the wrappers; returns what the compiler complains about, comments and their links included, or ""."""
	everything = [*sorted(WRAPPERS.glob("*.cs")), HERE / "godot_sharp.cs", MADE / "engine_classes.cs", *sources]
	kind = "exe" if out.suffix == ".exe" else "library"
	code, said = run([*mono("mcs.exe"), *FLAGS, f"-target:{kind}", f"-doc:{out.with_suffix('.xml')}", f"-out:{out}", *map(str, everything)])
	return said or f"it ended with code {code}" if code else ""


def engine_classes(classes):
	"""Returns the engine's classes that `classes` mention, and their ancestors, as C#."""
	api = json.loads((BUILD / "api/extension_api.json").read_text())
	parents = {made["name"]: made.get("inherits", "") for made in api["classes"]}
	values = [value for made in classes for value in made.members]
	values += [value for made in classes for method in made.methods for value in (method.result, *method.params)]
	wanted, found = {made.inherits for made in classes} | {value.type.removesuffix("[]") for value in values}, {}
	for name in wanted & set(parents):
		while name != "Object" and name:
			found[name], name = parents[name], parents[name]
	lines = [
		f"    public partial class {name} : {'GodotObject' if base == 'Object' else base} {{ }}" for name, base in sorted(found.items())
	]
	return "namespace Godot\n{\n" + "\n".join(lines) + "\n}\n"


def make():
	machine.ensure(COMPILER)
	MADE.mkdir(parents=True, exist_ok=True)
	for old in WRAPPERS.glob("*.cs") if WRAPPERS.exists() else ():
		old.unlink()
	wrappers.write(WRAPPERS)
	(MADE / "engine_classes.cs").write_text(engine_classes(reference.classes()))


def registered():
	"""Returns what the library registers with the engine, by class: tests/csharp/list_classes.gd."""
	command, environment = engine.headless()
	said = []
	engine.run([*command, "--path", str(PROJECT), "--script", str(HERE / "list_classes.gd")], environment, said.append, LIMIT)
	listed = next((line for line in said if line.startswith("classes: ")), None)
	if listed is None:
		raise Failure("The engine lists no classes:\n" + "\n".join(said[-10:]))
	return json.loads(listed.removeprefix("classes: "))


def pairs(values):
	return [[value.name, value.type] for value in values]


def differences(made, real):
	"""Where a class of the class reference differs from what the library registers."""
	if made.inherits != real["inherits"]:
		yield f"inherits {made.inherits}, not {real['inherits']}"
	methods = {
		method.name: [method.is_static, method.result.type, pairs(method.params), sum(p.default is not None for p in method.params)]
		for method in made.methods
	}
	accessors = {name for kind, *names in real["properties"].values() for name in names}
	public = {name for name in real["methods"] if not name.startswith("_") and name not in accessors} | set(methods)
	groups = (
		("method", methods, {name: real["methods"].get(name) for name in public}),
		("property", {value.name: value.type for value in made.members}, {name: told[0] for name, told in real["properties"].items()}),
		("signal", {event.name: pairs(event.params) for event in made.signals}, real["signals"]),
		("constant", {constant.name: constant.value for constant in made.constants}, real["constants"]),
	)
	for kind, told, known in groups:
		for name in sorted(set(told) | set(known)):
			if told.get(name) != known.get(name):
				yield f"{kind} {name} is {told.get(name)}, and registered as {known.get(name)}"


def wrong_classes():
	real, told = registered(), {made.name: made for made in reference.classes()}
	wrong = [f"{name} stands in one alone" for name in sorted(set(real) ^ set(told))]
	return "; ".join(
		[*wrong, *(f"{name}: {line}" for name in sorted(set(real) & set(told)) for line in differences(told[name], real[name]))]
	)


def wrong_run():
	wrong = compile(MADE / "check_wrappers.exe", HERE / "check_wrappers.cs")
	if wrong:
		return wrong
	code, said = run(mono(str(MADE / "check_wrappers.exe")))
	return said or f"it ended with code {code}" if code else ""


def wrong_block(block):
	"""Compiles a C# block of a page: a whole file."""
	source = MADE / f"{block.key}.cs"
	source.write_text(f'#line {block.line} "{ROOT / block.file}"\n{block.text}')
	return compile(MADE / f"{block.key}.dll", source)


def wrong_mistakes():
	"""Mistakes that the compiler must find in a user's code, or compiling shows nothing; the first is none."""
	found = []
	for name, code in {
		"": "field.SleepMode = GrassField.SleepModeEnum.Timer;",
		"a number for an enum": "field.SleepMode = 1;",
		"a wrong type": 'field.Density = "many";',
		"a map for a brush": "field.Paint(new GrassMap(), default(Vector3), default(Vector3));",
		"no such method": "field.BakeGrounds();",
		"a result": "int blades = field.GetBladeCount();",
		"a handler": "new GrassWorld().PlotLoaded += (Vector2I plot) => { };",
		"a property that is read only": "field.FillNow = default(Callable);",
		"an old name": "field.GetTiles();",
	}.items():
		source = MADE / "mistake.cs"
		source.write_text(f"using Godot; using GrassAddon; class Mistake {{ void Make(GrassField field) {{ {code} }} }}")
		said = compile(MADE / "mistake.dll", source)
		if bool(said) != bool(name):
			found.append(f"{name}: `{code}` compiles" if name else said)
	return "; ".join(found)


def layer(only):
	tally = Tally()
	make()
	checks = {
		"csharp/the class reference is what the library registers": wrong_classes,
		"csharp/the wrappers compile": lambda: compile(MADE / "wrappers.dll"),
		"csharp/the wrappers do what they say": wrong_run,
		"csharp/mistakes do not compile": wrong_mistakes,
		**{f"csharp/{block.place}": lambda block=block: wrong_block(block) for block in snippets.find() if block.language == "csharp"},
	}
	for name, wrong in checks.items():
		if only in name:
			noted(tally, name, wrong())
	return tally
