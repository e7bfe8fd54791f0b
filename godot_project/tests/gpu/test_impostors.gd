# SPDX-License-Identifier: MIT
## Plants with a mesh at some distance: their impostors are as light as their meshes, and are made beside the frames.
extends "res://tests/species_case.gd"

const SIZE := Vector2i(320, 180)
const FINER := 4  # times as many pixels a side, in pictures whose light is measured
const PRESETS := "res://addons/grass_field/presets/"
const DENSITIES := {fern = 40.0, ox_eye_daisy = 600.0, small_shrub = 32.0}  # as in the demo


func before() -> void:
	open_view(SIZE)
	add_light()
	var world: WorldEnvironment = viewport.find_children("*", "WorldEnvironment", true, false)[0]
	world.environment.background_color = Color.BLACK


## Linear, the mean of all pixels.
func light_of(image: Image) -> Color:
	image.convert(Image.FORMAT_RGB8)
	var bytes := image.get_data()
	var linear := PackedFloat64Array(range(256).map(func(value: int) -> float: return Color8(value, value, value).srgb_to_linear().r))
	var sums := [0.0, 0.0, 0.0]
	for channel in 3:
		for i in range(channel, bytes.size(), 3):
			sums[channel] += linear[bytes[i]]
	var pixels := bytes.size() / 3.0
	return Color(sums[0] / pixels, sums[1] / pixels, sums[2] / pixels)


func light_now(finer: int) -> Color:
	viewport.size = SIZE * finer
	picture_size = SIZE * finer
	return light_of(await picture())


## The field's last species by its impostors, over the same by its meshes.
func compare(field: GrassField, text: String) -> Color:
	var species: GrassSpecies = field.species[-1]
	species.plant_distance = 100.0
	var mesh := await light_now(FINER)
	await drawn()
	assert_greater(field.get_counters().drawn_plants, 20, text)
	species.plant_distance = 1.0
	var card := await light_now(FINER)
	await drawn()
	assert_greater(field.get_counters().drawn_impostors, 20, text)
	print(
		(
			"    %s: light by meshes %.4f, by impostors %.3f, %.3f, %.3f times"
			% [text, mesh.g, card.r / mesh.r, card.g / mesh.g, card.b / mesh.b]
		)
	)
	return Color(card.r / mesh.r, card.g / mesh.g, card.b / mesh.b)


## Before nothing, so all of the light is theirs.
func test_an_impostor_is_as_light_as_its_mesh() -> void:
	for name: String in DENSITIES:
		var species: GrassSpecies = load(PRESETS + name + ".tres").duplicate()
		species.share = 1.0
		var field := add_seen_field({species = [species] as Array[GrassSpecies], density = 2.0, soil_enabled = false})
		camera.fov = 20.0
		for height: float in [0.8, 1.7, 6.0]:
			look(Vector3(0, height, sqrt(144.0 - height * height)), Vector3(0, 0.2, 0))
			var light := await compare(field, "%s from %.1f m" % [name, height])
			assert_near(light.g, 1.0, 0.09, name)
			assert_near(light.r, 1.0, 0.09, name)
		field.free()


## As presets are meant to be used, at the distances at which their meshes are drawn in so dense a stand.
func test_a_patch_with_impostors_has_the_colour_of_one_with_meshes() -> void:
	# Compatibility draws in eight bits, of which a fern's blue takes a few.
	var blue := 0.12 if RenderingServer.get_current_rendering_method() == "gl_compatibility" else 0.08
	for name: String in DENSITIES:
		var species: GrassSpecies = load(PRESETS + name + ".tres").duplicate()
		var list: Array[GrassSpecies] = [species]
		if species.share < 0.3:
			list.push_front(load(PRESETS + "meadow.tres"))
		var field := add_seen_field({species = list, density = DENSITIES[name]})
		for distance: float in [3.0, 5.0]:
			camera.fov = rad_to_deg(2.0 * atan(1.0 / distance))
			look(Vector3(0, 1.7, sqrt(distance * distance - 1.7 * 1.7)), Vector3(0, 0.2, 0))
			var light := await compare(field, "a patch of %s at %.0f m" % [name, distance])
			assert_near(light.r, 1.0, 0.05, name)
			assert_near(light.g, 1.0, 0.05, name)
			assert_near(light.b, 1.0, blue, name)
		field.free()


## Large faces, so many that their pictures take a while.
func heavy_mesh() -> ArrayMesh:
	var tool := SurfaceTool.new()
	var quad := QuadMesh.new()
	for i in 60:
		tool.append_from(quad, 0, Transform3D(Basis(Vector3.UP, 0.1 * i), Vector3(0, 0.5, 0)))
	return tool.commit()


func test_pictures_are_drawn_beside_the_frames() -> void:
	var species := make(1.0, Color(0.3, 0.6, 0.2), {plant_mesh = BoxMesh.new()})
	var field := add_seen_field({species = [species] as Array[GrassSpecies], density = 2.0})
	await drawn()  # its shaders are there
	species.plant_mesh = heavy_mesh()
	var waiting := 0
	while waiting < 1000 and (waiting == 0 or field.get_statistics().waiting):
		waiting += 1
		await frames(1)
	print("    %d frames while pictures are drawn" % waiting)
	assert_greater(waiting, 1, "frames are drawn meanwhile")
	assert_false(field.get_statistics().waiting)
	await drawn()
	assert_greater(field.get_counters().drawn_plants + field.get_counters().drawn_impostors, 10)
