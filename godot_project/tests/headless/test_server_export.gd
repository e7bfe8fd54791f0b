# SPDX-License-Identifier: MIT
## A project with a rule and its mask, exported for a dedicated server as the engine does by default (*Strip Visuals*): the server answers
## as the project itself does.
extends "res://tests/case.gd"

const FOLDER := "user://server_export"
const SETTINGS := """config_version=5
[application]
config/name="Server"
run/main_scene="res://main.tscn"
[editor_plugins]
enabled=PackedStringArray()
"""
const PRESETS := """[preset.0]
name="Server"
platform="Linux"
runnable=true
dedicated_server=true
custom_features=""
export_filter="customized"
customized_files={"res://": "strip"}
include_filter="*.gdextension"
exclude_filter=""
export_path=""
script_export_mode=2
[preset.0.options]
binary_format/embed_pck=false
binary_format/architecture="x86_64"
texture_format/s3tc_bptc=true
texture_format/etc2_astc=false
"""
const MAIN := """[gd_scene load_steps=6 format=3]
[ext_resource type="Texture2D" path="res://mask.png" id="1"]
[ext_resource type="GrassFillRule" path="res://rule.tres" id="2"]
[ext_resource type="Script" path="res://main.gd" id="3"]
[sub_resource type="GrassFillRule" id="4"]
mask = ExtResource("1")
[node name="Main" type="Node3D"]
script = ExtResource("3")
[node name="Inside" type="GrassField" parent="."]
size = Vector2(16, 16)
density = 16.0
fill_rule = SubResource("4")
[node name="File" type="GrassField" parent="."]
size = Vector2(16, 16)
density = 16.0
fill_rule = ExtResource("2")
"""
const RULE := """[gd_resource type="GrassFillRule" load_steps=2 format=3]
[ext_resource type="Texture2D" path="res://mask.png" id="1"]
[resource]
mask = ExtResource("1")
"""
const SCRIPT := """extends Node3D

func _process(_delta: float) -> void:
	for field: GrassField in get_children():
		var now := field.get_statistics()
		if now.waiting or now.fill_waiting > 0 or now.map_waiting > 0 or now.tiles == 0:
			return
	var answers := []
	for field: GrassField in get_children():
		for x: float in [-4.0, 4.0]:
			answers.append(field.density_at(Vector3(x, 0, 1)))
		answers.append(field.fill_rule.get_mask_state() == GrassFillRule.MASK_READY)
		answers.append(field.fill_rule.mask.get_class() == "PlaceholderTexture2D")
	print("answers: ", JSON.stringify(answers))
	get_tree().quit()
"""


func write(path: String, text: String) -> void:
	FileAccess.open(FOLDER.path_join(path), FileAccess.WRITE).store_string(text)


func after() -> void:
	if DirAccess.dir_exists_absolute(FOLDER):
		OS.execute("rm", ["-r", ProjectSettings.globalize_path(FOLDER)])


func run(arguments: Array) -> String:
	var output := []
	OS.execute(OS.get_executable_path(), ["--headless"] + arguments, output, true)
	return output[0]


func answers_of(output: String) -> Variant:
	for line in output.split("\n"):
		if line.begins_with("answers: "):
			return JSON.parse_string(line.trim_prefix("answers: "))
	return output.right(400)


func test_a_server_that_was_stripped_grows_the_same_grass() -> void:
	var folder := ProjectSettings.globalize_path(FOLDER)
	DirAccess.make_dir_recursive_absolute(folder.path_join("addons"))
	DirAccess.open(folder).create_link(ProjectSettings.globalize_path("res://addons/grass_field"), folder.path_join("addons/grass_field"))
	var mask := Image.create(8, 8, false, Image.FORMAT_L8)
	mask.fill_rect(Rect2i(0, 0, 4, 8), Color.WHITE)
	mask.save_png(folder.path_join("mask.png"))
	write("project.godot", SETTINGS)
	write("export_presets.cfg", PRESETS)
	write("main.tscn", MAIN)
	write("rule.tres", RULE)
	write("main.gd", SCRIPT)
	var imported := run(["--path", folder, "--import"])
	var client: Variant = answers_of(run(["--path", folder, "--fixed-fps", "60", "--quit-after", "600"]))
	assert_eq(client, [1.0, 0.0, true, false, 1.0, 0.0, true, false], "the project itself; " + imported.right(200))
	var pack := folder.path_join("server.pck")
	var exported := run(["--path", folder, "--export-pack", "Server", pack])
	if assert_true(FileAccess.file_exists(pack), exported.right(400)):
		var elsewhere := ProjectSettings.globalize_path("user://")
		var server: Variant = answers_of(run(["--path", elsewhere, "--main-pack", pack, "--fixed-fps", "60", "--quit-after", "600"]))
		assert_eq(server, [1.0, 0.0, true, true, 1.0, 0.0, true, true], "the server")
