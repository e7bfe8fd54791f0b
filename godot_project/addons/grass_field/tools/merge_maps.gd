# SPDX-License-Identifier: MIT
## Merges two .grassmap files that began as the same one, texel by texel; also a merge driver for git (docs/guide/shared_maps.md):
##   godot --headless --path PROJECT --script res://addons/grass_field/tools/merge_maps.gd -- BASE MINE THEIRS [NAME]
## Writes the result into MINE, or with --output=FILE into FILE. What both changed stays as it is in MINE, with --theirs as in THEIRS.
## NAME: for messages. Exit code: 0 merged, 1 merged with conflicts, 2 nothing was written.
extends SceneTree

const MERGED := 0
const CONFLICT := 1
const FAILED := 2


func _initialize() -> void:
	quit(_run(OS.get_cmdline_user_args()))


func _run(arguments: PackedStringArray) -> int:
	var files: Array[String] = []
	var output := ""
	var prefer_theirs := false
	for argument in arguments:
		if argument == "--theirs":
			prefer_theirs = true
		elif argument.begins_with("--output="):
			output = argument.trim_prefix("--output=")
		elif argument.begins_with("--"):
			return _refuse("%s is no option" % argument)
		else:
			files.append(argument)
	if files.size() < 3 or files.size() > 4:
		return _refuse("expected BASE MINE THEIRS [NAME], got %d files" % files.size())
	var maps: Array[GrassMap] = []
	for file in files.slice(0, 3):
		maps.append(_read(_place_of(file), maps.is_empty()))
		if not maps[-1]:
			return FAILED
	var report := maps[1].merge(maps[0], maps[2], prefer_theirs)
	if report.is_empty() or maps[1].save_to_file(_place_of(output if output else files[1])) != OK:
		return FAILED
	return _tell(files[-1] if files.size() == 4 else files[1], report, "theirs" if prefer_theirs else "mine")


func _refuse(reason: String) -> int:
	printerr("merge_maps.gd: %s. Options: --theirs, --output=FILE" % reason)
	return FAILED


## The engine changes into the project's folder; the shell's own folder is where git and people name files from.
func _place_of(file: String) -> String:
	var from_shell := OS.get_environment("PWD").path_join(file)
	return from_shell if file.is_relative_path() and DirAccess.dir_exists_absolute(from_shell.get_base_dir()) else file


## Git's base of a map that both have added is an empty file. Any other empty file is damaged: a full disk, a failed checkout.
func _read(path: String, is_base: bool) -> GrassMap:
	if is_base and FileAccess.file_exists(path) and FileAccess.get_file_as_bytes(path).is_empty():
		return GrassMap.new()
	return GrassMap.load_from_file(path)


func _tell(map_name: String, report: Dictionary, kept: String) -> int:
	print("%s: %d texels merged" % [map_name, report.texels])
	var channels := ClassDB.class_get_enum_constants("GrassMap", "Channel")
	for conflict: Dictionary in report.conflicts:
		var channel: String = channels[conflict.channel].trim_prefix("CHANNEL_").to_lower()
		var region: Rect2 = conflict.region
		print("CONFLICT: %s of %d texels from %s to %s m; kept %s" % [channel, conflict.texels, region.position, region.end, kept])
	if report.base_density_conflict:
		print("CONFLICT: base_density; kept %s" % kept)
	return CONFLICT if report.conflicts or report.base_density_conflict else MERGED
