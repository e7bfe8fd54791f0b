# SPDX-License-Identifier: MIT
## A project with a painted GrassWorld, exported as *Export selected scenes*: the engine packs what the scenes refer to, and the add-on's
## plugin adds its library and the plots of the worlds in them.
extends "res://tests/export_case.gd"

const SETTINGS := """config_version=5
[application]
config/name="Selected"
run/main_scene="res://main.tscn"
"""
const PRESET := """[preset.%d]
name="%s"
platform="Linux"
runnable=false
dedicated_server=false
custom_features=""
export_filter="%s"
export_files=PackedStringArray("res://main.tscn")
include_filter="%s"
exclude_filter="%s"
export_path=""
script_export_mode=2
[preset.%d.options]
binary_format/embed_pck=false
binary_format/architecture="x86_64"
texture_format/s3tc_bptc=true
texture_format/etc2_astc=false
"""
const PRESETS := [  # name, filter, included, excluded
	["Scenes", "scenes", "", ""],
	["Resources", "resources", "", ""],
	["Named", "scenes", "*.gdextension, res://grass/*.grassmap", ""],
	["Without", "scenes", "", "*.gdextension,other/*"],
	["Lost", "scenes", "", "grass/*"],
]
const MAIN := """[gd_scene load_steps=4 format=3]
[ext_resource type="Script" path="res://main.gd" id="1"]
[ext_resource type="PackedScene" path="res://place.tscn" id="2"]
[ext_resource type="PackedScene" path="res://plot.tscn" id="3"]
[node name="Main" type="Node3D"]
script = ExtResource("1")
[node name="Own" type="GrassWorld" parent="."]
plot_scene = ExtResource("3")
size = Vector2(128, 128)
plot_size = 64.0
radius = 64.0
folder = "res://grass"
[node name="Place" parent="." instance=ExtResource("2")]
folder = "res://other/plots"
"""
const PLACE := """[gd_scene load_steps=2 format=3]
[ext_resource type="PackedScene" path="res://plot.tscn" id="3"]
[node name="Place" type="GrassWorld"]
plot_scene = ExtResource("3")
size = Vector2(128, 128)
plot_size = 64.0
radius = 64.0
folder = "res://grass"
"""
const PLOT := """[gd_scene format=3]
[node name="Plot" type="GrassField"]
density = 4.0
pool_tiles = 128
"""
const SCRIPT := """extends Node3D

func files_in(path: String) -> Array:
	return Array(DirAccess.get_files_at(path)) if DirAccess.dir_exists_absolute(path) else []

func _ready() -> void:
	add_child(Camera3D.new())

func _process(_delta: float) -> void:
	OS.delay_msec(5)  # threads read the plots
	for world: Node3D in [$Own, $Place]:
		if world.get_fields().is_empty() or world.get_statistics().files_waiting > 0:
			return
	var answers := [$Own.get_statistics().files_read, $Place.get_statistics().files_read]
	answers.append(files_in("res://grass"))
	answers.append(files_in("res://other/plots"))
	answers.append(files_in("res://unused"))
	print("answers: ", JSON.stringify(answers))
	get_tree().quit()
"""
const PLOTS := ["res://grass/plot_0_0.grassmap", "res://other/plots/plot_-1_0.grassmap", "res://unused/plot_0_0.grassmap"]


func presets() -> String:
	var text := ""
	for i in PRESETS.size():
		text += PRESET % ([i] + PRESETS[i] + [i])
	return text


func make_project(folder: String) -> void:
	make_folder(folder)
	write("project.godot", SETTINGS)
	write("export_presets.cfg", presets())
	write("main.tscn", MAIN)
	write("place.tscn", PLACE)
	write("plot.tscn", PLOT)
	write("main.gd", SCRIPT)
	var map := GrassMap.new()
	map.set_ground(flat(), Rect2(-8, -8, 16, 16))
	for plot: String in PLOTS:
		var path := folder.path_join(plot.trim_prefix("res://"))
		DirAccess.make_dir_recursive_absolute(path.get_base_dir())
		assert_eq(ResourceSaver.save(map, path), OK, path)
	DirAccess.make_dir_recursive_absolute(folder.path_join("game/addons/grass_field"))
	write("game/.gdignore", "")
	DirAccess.make_dir_recursive_absolute(folder.path_join(".godot"))
	write(".godot/extension_list.cfg", "res://addons/grass_field/grass_field.gdextension\n")


func flat() -> Image:
	var heights := Image.create(8, 8, false, Image.FORMAT_RF)
	heights.fill(Color(1.5, 0, 0))
	return heights


## Returns what the export prints.
func export_pack(preset: String) -> String:
	var folder := ProjectSettings.globalize_path(FOLDER)
	var pack := folder.path_join("game/%s.pck" % preset)
	var said := run(["--path", folder, "--export-pack", preset, pack])
	assert_true(FileAccess.file_exists(pack), said.right(600))
	return said


## Returns what a game prints that was given the library, or not, and nothing else of the project.
func play(preset: String, has_library := true) -> String:
	var game := ProjectSettings.globalize_path(FOLDER).path_join("game")
	var link := game.path_join("addons/grass_field/bin")
	if has_library:
		DirAccess.open(game).create_link(ProjectSettings.globalize_path("res://addons/grass_field/bin"), link)
	else:
		DirAccess.remove_absolute(link)
	return run(
		[
			"--path",
			game,
			"--main-pack",
			game.path_join(preset + ".pck"),
			"--fixed-fps",
			"60",
			"--quit-after",
			"4000" if has_library else "2"
		]
	)


func test_selected_scenes_take_the_library_and_the_plots_with_them() -> void:
	make_project(ProjectSettings.globalize_path(FOLDER))
	var whole := [1.0, 1.0, ["plot_0_0.grassmap"], ["plot_-1_0.grassmap"], []]
	var said := export_pack("Scenes")
	assert_eq(said.count("Added res://addons/grass_field/grass_field.gdextension"), 1, said.right(900))
	assert_eq(said.count("Added 1 painted plots in 'res://grass', the `folder` of a GrassWorld in res://"), 1, said.right(900))
	assert_eq(said.count("Added 1 painted plots in 'res://other/plots', the `folder` of a GrassWorld in res://main.tscn"), 1)
	assert_false(said.contains("exported, so"), said.right(900))
	var played := play("Scenes")
	assert_eq(answers_of(played), whole, "selected scenes")
	assert_false(played.contains("holds no plot"), played.right(600))
	assert_true(play("Scenes", false).contains("dynamic library not found: 'res://addons/grass_field/"), "without its file")
	export_pack("Resources")
	assert_eq(answers_of(play("Resources")), whole, "selected resources")


func test_what_the_preset_names_or_excludes_is_left_to_it() -> void:
	make_project(ProjectSettings.globalize_path(FOLDER))
	var said := export_pack("Named")
	assert_false(said.contains("Added res://"), said.right(900))
	assert_false(said.contains("in 'res://grass'"), "the engine packs these")
	assert_eq(said.count("Added 1 painted plots in 'res://other/plots'"), 1, said.right(900))
	assert_eq(answers_of(play("Named")), [1.0, 1.0, ["plot_0_0.grassmap"], ["plot_-1_0.grassmap"], []])
	said = export_pack("Without")
	assert_eq(said.count("grass_field.gdextension is not exported, so the game will have no grass"), 1, said.right(900))
	assert_eq(said.count("1 plots in 'res://other/plots', the `folder` of a GrassWorld in res://main.tscn, are not exported"), 1)
	said = export_pack("Lost")
	assert_true(said.contains("Added res://addons"), said.right(900))
	var played := play("Lost")
	assert_eq(answers_of(played), [0.0, 1.0, [], ["plot_-1_0.grassmap"], []])
	assert_eq(played.count("GrassWorld '/root/Main/Own': `folder` ('res://grass') holds no plot"), 1, played.right(900))
