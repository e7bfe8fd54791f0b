# SPDX-License-Identifier: MIT
## Size limits of maps from untrusted sources: small files and messages that would unpack to gigabytes, and chunks far from any field. The
## same for pictures that are read.
extends "res://tests/world_case.gd"

const MAP_SETTING := "grass_field/limits/map_megabytes"
const CHANGES_SETTING := "grass_field/limits/changes_megabytes"
const FILE := "user://test_size_limits.grassmap"


func after() -> void:
	super()
	ProjectSettings.set_setting(MAP_SETTING, ProjectSettings.property_get_revert(MAP_SETTING))
	ProjectSettings.set_setting(CHANGES_SETTING, ProjectSettings.property_get_revert(CHANGES_SETTING))
	if FileAccess.file_exists(FILE):
		DirAccess.remove_absolute(FILE)


## 64 chunks of one slope: 1.5 MB of texels that pack to some kilobytes.
func even_map() -> GrassMap:
	var map := GrassMap.new()
	var heights := Image.create(2, 2, false, Image.FORMAT_RF)
	heights.fill(Color(1, 0, 0))
	heights.fill_rect(Rect2i(1, 0, 1, 2), Color(100, 0, 0))
	map.set_ground(heights, Rect2(-255, -255, 510, 510))
	return map


func test_the_limits_are_project_settings() -> void:
	assert_eq(ProjectSettings.get_setting(MAP_SETTING), 1024)
	assert_eq(ProjectSettings.get_setting(CHANGES_SETTING), 64)


func test_a_file_that_unpacks_to_too_much_is_refused_by_name() -> void:
	var map := even_map()
	assert_eq(map.get_chunks().size(), 64)
	assert_greater(map.get_memory_usage(), 1 << 20)
	assert_less(map.data.size(), 100000, "packed")
	var other := GrassMap.new()
	other.data = map.data
	assert_eq(other.get_chunks().size(), 64)
	ProjectSettings.set_setting(MAP_SETTING, 1)
	expect_error("It is saved, but it cannot be loaded until that limit is raised (the project setting %s)" % MAP_SETTING)
	assert_eq(ResourceSaver.save(map, FILE), OK)
	expect_error("the file would take 2 MB of memory, but a map may take at most 1 MB (the project setting %s)" % MAP_SETTING)
	allow_error("Error loading resource")
	allow_error("Failed loading resource")
	assert_true(ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE) == null)


func test_a_message_may_change_so_much() -> void:
	var server := GrassMap.new()
	var before := server.take_snapshot()
	var changes := even_map().get_changes_since(before)
	ProjectSettings.set_setting(CHANGES_SETTING, 1)
	expect_error("would change 2 MB of the map, but one message may change at most 1 MB (the project setting %s)" % CHANGES_SETTING)
	assert_false(server.apply_changes(changes))
	assert_true(server.is_empty())
	ProjectSettings.set_setting(CHANGES_SETTING, 2)
	assert_true(server.apply_changes(changes))
	assert_eq(server.get_chunks().size(), 64)


func test_a_field_takes_no_chunks_from_far_away() -> void:
	var field := add_field({size = Vector2(64, 64), map = full_map()})
	await grown(field)
	var server := full_map()
	var before := server.take_snapshot()
	var cut := brush(GrassBrush.TOOL_CUT, 2.0)
	server.stroke(cut, Vector2(16000, 0), Vector2(16000, 0))
	expect_error("the cut of chunk (249, -1) is outside of every field that shows this map")
	assert_false(field.map.apply_changes(server.get_changes_since(before)))
	assert_true(field.map.is_empty())
	server = full_map()
	server.stroke(cut, Vector2(31, 0), Vector2(31, 0))
	assert_true(field.map.apply_changes(server.get_changes_since(before)), "under the field")
	assert_eq(field.map.get_chunks().size(), 2)


func test_a_plot_takes_no_chunks_of_other_plots() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var far := full_map()
	far.stroke(brush(GrassBrush.TOOL_CUT, 2.0), Vector2(1000, 0), Vector2(1000, 0))
	ResourceSaver.save(far, FOLDER.path_join("plot_0_0.grassmap"))
	expect_error("which is outside of the ground that it is for")
	var world := add_world()
	await loaded(world)
	assert_eq(world.get_statistics().files_refused, 1)
	assert_true(world.get_field(Vector2i(0, 0)) != null, "its plot stands as if there were none")


## Small in a file, and in memory: a row of grey texels, one more than are read.
func long_picture() -> ImageTexture:
	return ImageTexture.create_from_image(Image.create(8193, 1, false, Image.FORMAT_L8))


## Reads what a species shows, which a field does without being drawn.
func shown(species: GrassSpecies) -> GrassField:
	var field := add_field({species = [species] as Array[GrassSpecies]})
	await grown(field)
	return field


func test_pictures_of_species_have_a_limit() -> void:
	for property: String in ["card", "leaf"]:
		var species := GrassSpecies.new()
		species.resource_name = "Reed"
		species.set(property, long_picture())
		expect_error("GrassSpecies 'Reed': the picture of `%s` has 8193 x 1 texels, but at most 8192 along a side are read." % property)
		(await shown(species)).free()


func test_a_plant_whose_texture_is_too_large_stands_in_white() -> void:
	var material := StandardMaterial3D.new()
	material.albedo_texture = long_picture()
	var species := GrassSpecies.new()
	species.resource_name = "Fern"
	species.plant_mesh = QuadMesh.new()
	species.plant_mesh.material = material
	expect_error(
		"GrassSpecies 'Fern': `plant_mesh`: far plants are drawn as if they were white, since an albedo texture has 8193 x 1 texels"
	)
	var field := await shown(species)
	assert_greater(field.get_blade_count(), 0)


func test_a_stamp_that_is_too_large_leaves_nothing() -> void:
	var stamp := brush(GrassBrush.TOOL_CUT, 1.0)
	stamp.resource_name = "Mark"
	expect_error("GrassBrush 'Mark': the picture of `stamp` has 8193 x 1 texels")
	stamp.stamp = long_picture()
	var map := full_map()
	map.stroke(stamp, Vector2.ZERO, Vector2.ZERO)
	assert_true(map.is_empty())
	var white := Image.create(8192, 1, false, Image.FORMAT_L8)
	white.fill(Color.WHITE)
	stamp.stamp = ImageTexture.create_from_image(white)
	map.stroke(stamp, Vector2.ZERO, Vector2.ZERO)
	assert_false(map.is_empty(), "the largest that is read")


func test_nothing_grows_by_a_mask_that_is_too_large() -> void:
	var rule := GrassFillRule.new()
	rule.resource_name = "Shore"
	rule.mask = long_picture()
	expect_error("GrassFillRule 'Shore': the picture of `mask` has 8193 x 1 texels")
	var field := add_field({map = full_map(), fill_rule = rule})
	await grown(field)
	assert_eq(field.get_density_at(Vector3.ZERO), 0.0)
