# SPDX-License-Identifier: MIT
## Plays a record of GrassField.record() and compares its grass in each tick (docs/guide/recording.md):
##   godot --headless --fixed-fps 60 --path PROJECT --script res://addons/grass_field/tools/play_record.gd -- FILE
## Exit code: 0 the same, or not comparable; 1 other grass, and the first such tick is printed; 2 the file cannot be played to its end.
extends SceneTree

const SAME := 0
const DIFFERENT := 1
const FAILED := 2


func _initialize() -> void:
	var arguments := OS.get_cmdline_user_args()
	if arguments.size() != 1:
		printerr("play_record.gd: expected one FILE, got %d" % arguments.size())
		quit(FAILED)
		return
	quit(await _play(_place_of(arguments[0])))


## The engine changes into the project's folder; the shell's own folder is where people name files from.
func _place_of(file: String) -> String:
	var from_shell := OS.get_environment("PWD").path_join(file)
	return from_shell if file.is_relative_path() and FileAccess.file_exists(from_shell) else file


func _play(path: String) -> int:
	var field := GrassField.new()
	root.add_child(field)
	await physics_frame
	if field.play_record(path) != OK:
		return FAILED
	while field.get_record_state().mode == "playing":
		await physics_frame
	return _tell(path, field.get_record_state())


func _tell(path: String, state: Dictionary) -> int:
	var from := "GrassField %s, Godot %s, %s" % [state.version, state.engine, state.backend]
	print("%s: %d ticks (%s); the record %s" % [path, state.ticks, from, state.message])
	if state.differs_at >= 0:
		print("The grass differs from tick %d on." % state.differs_at)
		return DIFFERENT
	if state.compared > 0:
		print("The grass is the same in %d ticks." % state.compared)
	else:
		print("No tick can be compared: the grass was on a GPU.")
	return SAME if state.complete else FAILED
