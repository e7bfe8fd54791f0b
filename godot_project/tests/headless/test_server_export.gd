# SPDX-License-Identifier: MIT
## A project with a rule and its mask, exported for a dedicated server with the engine's default (*Strip Visuals*): the server gives the
## same answers as the project itself.
extends "res://tests/export_case.gd"

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
const NOISE := """[gd_resource type="GrassFillRule" load_steps=3 format=3]
[sub_resource type="FastNoiseLite" id="1"]
[sub_resource type="NoiseTexture2D" id="2"]
noise = SubResource("1")
[resource]
mask = SubResource("2")
"""
const SCRIPT := """extends Node3D

func _process(_delta: float) -> void:
	for field: GrassField in get_children():
		var counters := field.get_counters()
		var waits: bool = field.get_statistics().waiting or counters.fill_waiting > 0 or counters.map_waiting > 0
		if waits or field.get_grid_size() == Vector2i.ZERO:
			return
	var answers := []
	for field: GrassField in get_children():
		for x: float in [-4.0, 4.0]:
			answers.append(field.get_density_at(Vector3(x, 0, 1)))
		answers.append(field.fill_rule.get_mask_state() == GrassFillRule.MASK_STATE_READY)
		answers.append(field.fill_rule.mask.get_class() == "PlaceholderTexture2D")
		field.fill_rule.mask = load("res://mask.png")
		answers.append(field.fill_rule.get_mask_state() == GrassFillRule.MASK_STATE_READY)
	print("answers: ", JSON.stringify(answers))
	get_tree().quit()
"""


func save_mask(grass_at: int) -> void:
	var mask := Image.create(8, 8, false, Image.FORMAT_L8)
	mask.fill_rect(Rect2i(grass_at, 0, 4, 8), Color.WHITE)
	mask.save_png(ProjectSettings.globalize_path(FOLDER).path_join("mask.png"))


func make_project(folder: String) -> void:
	make_folder(folder)
	save_mask(0)
	write("project.godot", SETTINGS)
	write("export_presets.cfg", PRESETS)
	write("main.tscn", MAIN)
	write("rule.tres", RULE)
	write("noise.tres", NOISE)
	write("main.gd", SCRIPT)
	var addons := folder.path_join("elsewhere/addons/grass_field")  # a server has the library, and nothing else of the project
	DirAccess.make_dir_recursive_absolute(addons)
	DirAccess.open(addons).create_link(ProjectSettings.globalize_path("res://addons/grass_field/bin"), addons.path_join("bin"))
	write("elsewhere/.gdignore", "")


## Returns what the server says; `r_exported` gets what the export printed.
func export_and_ask(folder: String, r_exported: Array[String]) -> Variant:
	var pack := folder.path_join("elsewhere/server.pck")
	r_exported.append(run(["--path", folder, "--export-pack", "Server", pack]))
	if not assert_true(FileAccess.file_exists(pack), r_exported[-1].right(400)):
		return null
	return answers_of(run(["--path", pack.get_base_dir(), "--main-pack", pack, "--fixed-fps", "60", "--quit-after", "600"]))


func test_a_server_that_was_stripped_grows_the_same_grass() -> void:
	var folder := ProjectSettings.globalize_path(FOLDER)
	make_project(folder)
	var exported: Array[String] = []
	var server: Variant = export_and_ask(folder, exported)
	var client: Variant = answers_of(run(["--path", folder, "--fixed-fps", "60", "--quit-after", "600"]))  # what the export imported
	assert_eq(client, [1.0, 0.0, true, false, true, 1.0, 0.0, true, false, true], "the project itself; " + exported[0].right(400))
	assert_eq(server, [1.0, 0.0, true, true, false, 1.0, 0.0, true, true, false], "the server; " + exported[0].right(400))
	assert_true(exported[0].contains("The mask of the GrassFillRule 'res://noise.tres' has no picture"), exported[0].right(400))
	assert_eq(exported[0].count("has no picture while"), 1)
	save_mask(4)  # the export imports it
	server = export_and_ask(folder, exported)
	assert_eq(server, [0.0, 1.0, true, true, false, 0.0, 1.0, true, true, false], "with another picture; " + exported[1].right(400))
