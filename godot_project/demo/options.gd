# SPDX-License-Identifier: MIT
## The arguments of a demo: pairs of --NAME VALUE behind the `--` of the command line.
extends RefCounted


## `p_defaults`, by name, with the values of the command line, in the types of the defaults. Arguments with other names are another scene's.
static func read(p_defaults: Dictionary) -> Dictionary:
	var options := p_defaults.duplicate()
	var given := all()
	for name: String in options:
		if given.has(name):
			options[name] = type_convert(given[name], typeof(options[name]))
	return options


## Returns all arguments, by name.
static func all() -> Dictionary[String, String]:
	var given: Dictionary[String, String] = {}
	var arguments := OS.get_cmdline_user_args()
	for i in range(0, arguments.size() - 1, 2):
		given[arguments[i].trim_prefix("--")] = arguments[i + 1]
	return given
