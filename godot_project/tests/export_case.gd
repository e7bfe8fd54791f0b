# SPDX-License-Identifier: MIT
## A test that writes a small project, exports it with the engine that runs the test, and plays the export.
extends "res://tests/case.gd"

const FOLDER := "user://exported"  # of the project


func after() -> void:
	if DirAccess.dir_exists_absolute(FOLDER):
		OS.execute("rm", ["-r", ProjectSettings.globalize_path(FOLDER)])


func write(path: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(path), FileAccess.WRITE).store_string(text)


## Makes the project's folder and links the add-on into it.
func make_folder(folder: String) -> void:
	DirAccess.make_dir_recursive_absolute(folder.path_join("addons"))
	DirAccess.open(folder).create_link(ProjectSettings.globalize_path("res://addons/grass_field"), folder.path_join("addons/grass_field"))


## Returns the output of the engine with these arguments, headless.
func run(arguments: Array) -> String:
	var output := []
	OS.execute(OS.get_executable_path(), ["--headless"] + arguments, output, true)
	return output[0]


## Returns what the project printed behind `answers: `; else the end of its output.
func answers_of(output: String) -> Variant:
	for line in output.split("\n"):
		if line.begins_with("answers: "):
			return JSON.parse_string(line.trim_prefix("answers: "))
	return output.right(600)
