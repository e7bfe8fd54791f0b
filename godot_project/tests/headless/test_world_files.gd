# SPDX-License-Identifier: MIT
## Changes of plots belong to the folder and the plot size for which they were made, and are saved nowhere else.
extends "res://tests/world_case.gd"

const SLOT_1 := "user://test_world_slot_1"
const SLOT_2 := "user://test_world_slot_2"
const PLACE := Vector3(64, 0, 64)  # in plot (0, 0)
const BESIDE := Vector3(20, 0, 20)


func before() -> void:
	super()
	for folder: String in [SLOT_1, SLOT_2]:
		empty_folder(folder)


func after() -> void:
	super()
	for folder: String in [SLOT_1, SLOT_2]:
		empty_folder(folder)


func erase(world: GrassWorld, place: Vector3) -> void:
	world.paint(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0}), place, place)


func density(world: GrassWorld, place := PLACE) -> float:
	return world.get_field_at(place).get_density_at(place)


## Returns what plot (0, 0) has in a folder's file.
func in_file(folder: String, place := PLACE) -> float:
	var path := folder.path_join("plot_0_0.grassmap")
	if not FileAccess.file_exists(path):
		return 1.0
	var map: GrassMap = ResourceLoader.load(path, "", ResourceLoader.CACHE_MODE_IGNORE)
	return map.sample(GrassMap.CHANNEL_DENSITY, Vector2(place.x - 0.5 * PLOT, place.z - 0.5 * PLOT))


## A file of plot (0, 0) that is bare at BESIDE.
func store_slot(folder: String) -> void:
	var map := full_map()
	var at := Vector2(BESIDE.x - 0.5 * PLOT, BESIDE.z - 0.5 * PLOT)
	map.stroke(brush(GrassBrush.TOOL_DENSITY, 3.0, {target = 0.0}), at, at)
	DirAccess.make_dir_recursive_absolute(folder)
	assert_eq(ResourceSaver.save(map, folder.path_join("plot_0_0.grassmap")), OK)


## The field of a plot keeps its size, and what a script paints outside of the plot is not written: the world would refuse the file.
func test_a_plot_is_written_as_it_may_be_read() -> void:
	var world := add_world({camera_radius = 100.0})
	await go(world, Vector3(64, 0, 64))
	var field := world.get_field(Vector2i(0, 0))
	expect_error("`size` of a plot's field follows `plot_size`")
	field.size = Vector2(900, 900)
	assert_eq(field.size, Vector2(PLOT, PLOT))
	expect_error("the map of plot (0, 0) has 1 chunks outside of the plot")
	for place: Vector2 in [Vector2.ZERO, Vector2(-420, 60)]:
		field.map.stroke(brush(GrassBrush.TOOL_ERASE, 3.0), place, place)
	await go(world, Vector3(3064, 0, 64))
	world.wait_for_files()
	await go(world, Vector3(64, 0, 64))
	assert_eq(world.get_statistics().files_refused, 0)
	field = world.get_field(Vector2i(0, 0))
	assert_eq(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2.ZERO), 0.0)
	assert_eq(field.map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-420, 60)), 1.0)


func test_an_unsaved_game_is_not_shown_in_another_slot_nor_written_there() -> void:
	store_slot(SLOT_2)
	expect_error("`folder` and `save_folder` are empty")
	expect_error("were never written, and belong to other folders")
	var world := add_world({folder = ""})
	await go(world, PLACE)
	erase(world, PLACE)
	world.save_folder = SLOT_2
	await go(world, PLACE)
	assert_eq(world.get_statistics().files_kept_elsewhere, 1)
	assert_eq(density(world), 1.0, "another game's")
	assert_eq(density(world, BESIDE), 0.0, "this slot's")
	world.save()
	world.wait_for_files()
	assert_eq(in_file(SLOT_2), 1.0, "not written")
	world.save_folder = ""
	await go(world, PLACE)
	assert_eq(density(world), 0.0, "there again")
	world.save_folder = SLOT_2
	await go(world, PLACE)
	assert_eq(world.discard_unsaved(), 1)
	await go(world, PLACE)
	assert_eq(world.get_statistics().files_kept, 0)
	assert_eq(density(world, BESIDE), 0.0)
	assert_eq(in_file(SLOT_2), 1.0)


func test_a_step_in_a_plot_takes_back_only_its_own_difference() -> void:
	var world := add_world({folder = SLOT_1})
	await go(world, PLACE)
	var map := world.get_field_at(PLACE).map
	var before_it := map.take_snapshot()
	erase(world, PLACE)
	var after_it := map.take_snapshot()
	erase(world, BESIDE)
	world.restore_plot(Vector2i.ZERO, before_it, after_it)
	assert_eq(density(world), 1.0, "undone")
	assert_eq(density(world, BESIDE), 0.0, "painted since, in the same chunk")
	world.discard_unsaved()


func test_an_unsaved_game_is_carried_over_when_it_is_asked_for() -> void:
	expect_error("`folder` and `save_folder` are empty")
	expect_error("were never written, and belong to other folders")
	var world := add_world({folder = ""})
	await go(world, PLACE)
	erase(world, PLACE)
	world.save_folder = SLOT_1
	await go(world, PLACE)
	assert_eq(density(world), 1.0)
	assert_eq(world.carry_unsaved(), 1)
	await go(world, PLACE)
	assert_eq(density(world), 0.0)
	world.wait_for_files()
	assert_eq(in_file(SLOT_1), 0.0, "and written")
	assert_eq(world.get_statistics().files_kept, 0)


func test_changes_are_discarded_also_of_plots_in_memory() -> void:
	store_slot(SLOT_1)
	var world := add_world({save_folder = SLOT_1})
	await go(world, PLACE)
	erase(world, PLACE)
	assert_eq(world.discard_unsaved(), 1)
	await go(world, PLACE)
	assert_eq(density(world), 1.0, "as it is in the file")
	assert_eq(density(world, BESIDE), 0.0)
	world.free()
	assert_eq(in_file(SLOT_1), 1.0)


func test_what_could_not_be_written_is_written_where_it_belongs() -> void:
	FileAccess.open(SLOT_1, FileAccess.WRITE).store_string("in the way of a folder")
	store_slot(SLOT_2)
	expect_error("cannot be written")
	expect_error("were never written, and belong to other folders")
	var world := add_world({save_folder = SLOT_1})
	await go(world, PLACE)
	erase(world, PLACE)
	world.save_folder = SLOT_2
	await go(world, PLACE)
	assert_eq(density(world), 1.0)
	world.save()
	world.wait_for_files()
	assert_eq(world.get_statistics().files_kept, 1, "still")
	DirAccess.remove_absolute(SLOT_1)
	world.save()
	world.wait_for_files()
	assert_eq(world.get_statistics().files_kept, 0)
	assert_eq(in_file(SLOT_1), 0.0, "in its own folder")
	assert_eq(in_file(SLOT_2), 1.0, "and not in the other one")


func test_plots_of_another_size_are_neither_shown_nor_spoiled() -> void:
	expect_error("holds plots of 128 m, but `plot_size` is 256 m")
	var world := add_world()
	await go(world, PLACE)
	erase(world, PLACE)
	world.plot_size = 256.0
	await go(world, PLACE)
	for place: Vector3 in [PLACE, Vector3(128, 0, 128)]:
		assert_eq(density(world, place), 1.0, "of no plot of this size")
	erase(world, Vector3(200, 0, 200))
	world.save()
	world.wait_for_files()
	assert_eq(world.get_statistics().files_kept, 1, "not written into files of the other size")
	assert_eq(in_file(FOLDER), 0.0)
	world.plot_size = PLOT
	await go(world, PLACE)
	assert_eq(density(world), 0.0, "where it was")
	assert_eq(density(world, Vector3(200, 0, 200)), 1.0)
	world.free()
	expect_error("was freed with unwritten changes of 1 plots")
	world = add_world({plot_size = 256.0})  # in the next game, too
	await go(world, PLACE)
	assert_eq(density(world, Vector3(128, 0, 128)), 1.0)


func test_each_broken_file_is_kept() -> void:
	expect_error("plot_0_0.grassmap")
	for name: String in ["first", "second", "third"]:
		DirAccess.make_dir_recursive_absolute(FOLDER)
		FileAccess.open(path_of(Vector2i(0, 0)), FileAccess.WRITE).store_string(name)
		var world := add_world()
		await go(world, PLACE)
		erase(world, PLACE)
		world.free()
		assert_eq(in_file(FOLDER), 0.0)
	var kept: Array[String] = []
	for end: String in ["unread", "unread2", "unread3"]:
		kept.append(FileAccess.get_file_as_string(path_of(Vector2i(0, 0)) + "." + end))
	assert_eq(kept, ["first", "second", "third"] as Array[String])


func test_two_worlds_that_write_to_one_folder() -> void:
	var first := add_world({name = "First"})
	expect_error("GrassWorld '%s' writes its plots to '%s/', too" % [first.get_path(), FOLDER])
	var second := add_world({folder = FOLDER + "/"})
	await go(second, PLACE)
	await loaded(first)
	for i in 30:
		erase(first, PLACE)
		erase(second, BESIDE)
		first.save()
		second.save()
		first.get_field_at(PLACE).map.base_density = 1.0 - 0.01 * i
	for world: GrassWorld in [first, second]:
		world.wait_for_files()
		assert_eq(world.get_statistics().files_kept, 0, "no write fails")


func test_a_world_that_is_freed_says_what_is_lost() -> void:
	expect_error("`folder` and `save_folder` are empty")
	expect_error("was freed with unwritten changes of 1 plots")
	var world := add_world({folder = ""})
	await go(world, PLACE)
	erase(world, PLACE)
	world.free()
	world = add_world({folder = ""})
	await go(world, PLACE)
	assert_eq(density(world), 1.0)
	world.free()


func test_what_cannot_be_put_aside_is_not_written_over() -> void:
	var broken := PackedByteArray([1, 2, 3])
	DirAccess.make_dir_recursive_absolute(FOLDER)
	FileAccess.open(path_of(Vector2i.ZERO), FileAccess.WRITE).store_buffer(broken)
	var aside := path_of(Vector2i.ZERO) + ".unread"
	DirAccess.make_dir_absolute(aside)  # as a file in use on Windows, it cannot be replaced
	FileAccess.open(aside.path_join("full"), FileAccess.WRITE).store_8(1)
	expect_error("has a map that cannot be read")
	expect_error("cannot be written")
	allow_error("rename")
	var world := add_world()
	await go(world, PLACE)
	erase(world, PLACE)
	world.save()
	world.wait_for_files()
	assert_eq(FileAccess.get_file_as_bytes(path_of(Vector2i.ZERO)), broken, "the file that nobody could read")
	DirAccess.remove_absolute(aside.path_join("full"))
	DirAccess.remove_absolute(aside)
	world.save()
	world.wait_for_files()
	assert_eq(FileAccess.get_file_as_bytes(aside), broken, "put aside, now that it can be")
	assert_eq(in_file(FOLDER), 0.0, "the changed plot")
