# SPDX-License-Identifier: MIT
## Plants with a mesh: they grow in the places of blades, bend and are mown like them, and are drawn as blades far away.
extends "res://tests/species_case.gd"

const GREEN := Color(0.3, 0.6, 0.2)
const VIOLET := Color(0.7, 0.1, 0.7)
const LENGTH := 0.7  # metres, of all blades


## Returns a thin stalk without colour to count, and a violet box on its tip.
func lollipop(side := 0.12, scissor := 0.0) -> ArrayMesh:
	var tool := SurfaceTool.new()
	var box := BoxMesh.new()
	box.size = Vector3(side, side, side)
	tool.append_from(box, 0, Transform3D(Basis(), Vector3(0, 1.0 - 0.5 * side, 0)))
	box.size = Vector3(0.01, 1.0, 0.01)
	tool.append_from(box, 0, Transform3D(Basis(), Vector3(0, 0.5, 0)))
	var mesh := tool.commit()
	var material := StandardMaterial3D.new()
	material.albedo_color = VIOLET
	if scissor > 0.0:
		var image := Image.create_empty(8, 8, false, Image.FORMAT_RGBA8)
		image.fill(Color(1, 1, 1, 0.3))
		material.albedo_texture = ImageTexture.create_from_image(image)
		material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR
		material.alpha_scissor_threshold = scissor
	mesh.surface_set_material(0, material)
	return mesh


func plant(share: float, properties := {}) -> GrassSpecies:
	var own := {plant_mesh = lollipop(), length_min = LENGTH, length_max = LENGTH, width_min = 0.004, width_max = 0.004}
	return make(share, GREEN, own.merged(properties, true))


## Few of them, each of which can be looked up.
func add_plants(species: Array[GrassSpecies], properties := {}) -> GrassField:
	var sparse := {
		species = species,
		size = Vector2(6, 6),
		density = 4.0,
		soil_enabled = false,
		border_fade = 0.0,
		lod_far = 1000.0,
		pixels_min = 0.0,
		sleep_mode = GrassField.SLEEP_TIMER,
		sleep_delay = 30.0
	}
	look(Vector3(0, 9, 5), Vector3.ZERO)
	return add_seen_field(sparse.merged(properties, true))


func heads(field: GrassField, of_species := 0) -> PackedVector3Array:
	var found := PackedVector3Array()
	var tiles := field.get_grid_size()
	for z in tiles.y:
		for x in tiles.x:
			for blade in BLADES:
				if field.get_blade_species(Vector2i(x, z), blade) == of_species:
					var knots := field.get_knots(Vector2i(x, z), blade)
					found.append(knots[KNOTS - 1].lerp(knots[KNOTS - 2], 0.6))
	return found


func share_of_heads(image: Image, places: PackedVector3Array) -> float:
	var seen := 0
	for place in places:
		seen += int(is_violet(image.get_pixelv(Vector2i(camera.unproject_position(place)))))
	return float(seen) / maxi(places.size(), 1)


func test_plants_stand_on_their_species_and_bend_with_them() -> void:
	var field := add_plants([make(0.5, GREEN), plant(0.5)])
	await drawn()
	var rest := heads(field, 1)
	var grass := heads(field, 0)
	var gpu := await next_picture()
	save(gpu, "plants")
	print(
		(
			"    %d plants, heads seen on %.3f of them, on %.3f of the grass"
			% [rest.size(), share_of_heads(gpu, rest), share_of_heads(gpu, grass)]
		)
	)
	assert_greater(share_of_heads(gpu, rest), 0.97)
	assert_less(share_of_heads(gpu, grass), 0.35)
	assert_eq(field.get_counters().drawn_plants, rest.size())
	assert_eq(field.get_counters().left_out_plants, 0)
	var body := add_held_body(ball(1.2), Vector3(0.2, 0.2, 0.2))
	body.reparent(viewport)  # into its world
	await ticks(30)
	await drawn()
	var bent := heads(field, 1)
	var image := await next_picture()
	save(image, "plants_bent")
	var moved := PackedVector3Array()
	var left := PackedVector3Array()
	for i in rest.size():
		if rest[i].distance_to(bent[i]) > 0.25:
			moved.append(bent[i])
			left.append(rest[i])
	print(
		(
			"    %d bent: seen where they are %.3f, where they were %.3f"
			% [moved.size(), share_of_heads(image, moved), share_of_heads(image, left)]
		)
	)
	assert_greater(moved.size(), 3)
	assert_greater(share_of_heads(image, moved), 0.7)
	assert_less(share_of_heads(image, left), 0.5)


func test_both_backends_draw_the_same_plants() -> void:
	var map := full_map()
	var field := add_plants([make(0.7, GREEN), plant(0.3, {stems = 4})], {map = map, density = 8.0})
	map.stroke(brush(GrassBrush.TOOL_SPECIES, 1.0, {species = 2, strength = 1.0}), Vector2(-2, 0), Vector2(2, 0))
	await drawn()
	var gpu := await next_picture()
	var count: int = field.get_counters().drawn_plants
	save(gpu, "plants_painted")
	assert_greater(count, 40)
	assert_eq(count, heads(field, 1).size())
	assert_greater(share_of_heads(gpu, heads(field, 1)), 0.85)  # heads of one root hide each other
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_eq(field.get_statistics().backend, "CPU")
	assert_eq(field.get_counters().drawn_plants, count)
	var off := difference(gpu, await next_picture())
	print("    GPU and CPU: %d plants, mean difference %.5f" % [count, off.y])
	assert_less(off.y, 0.003)


func test_mown_plants_are_cut() -> void:
	var map := full_map()
	var field := add_plants([plant(1.0)], {map = map})
	var before := share_of(await picture(), is_violet)
	map.stroke(brush(GrassBrush.TOOL_CUT, 6.0, {cut_height = 0.3}), Vector2.ZERO, Vector2.ZERO)
	var image := await picture()
	save(image, "plants_mown")
	print("    violet: %.4f, mown %.4f" % [before, share_of(image, is_violet)])
	assert_greater(before, 0.01)
	assert_less(share_of(image, is_violet), 0.25 * before)
	assert_greater(share_of(image, is_violet), 0.0, "stalks are left")


func test_alpha_scissor_cuts_what_is_transparent() -> void:
	var species := plant(1.0)
	add_plants([species])
	assert_greater(share_of(await picture(), is_violet), 0.01)
	species.plant_mesh = lollipop(0.12, 0.2)
	assert_greater(share_of(await picture(), is_violet), 0.01, "0.3 is above 0.2")
	species.plant_mesh = lollipop(0.12, 0.5)
	assert_eq(share_of(await picture(), is_violet), 0.0, "0.3 is below 0.5")


func test_far_plants_are_pictures_of_their_mesh() -> void:
	const PICTURES := 2 * 9 * 128 * 128 * 4 * 4 / 3  # bytes: colours and normals from eight sides and from above, with mipmaps
	# With a gradient the shaders of species stay, whatever else it has.
	var species := plant(1.0, {width_min = 0.02, width_max = 0.02, gradient = Gradient.new()})
	var field := add_plants([species])
	await drawn()
	var near := share_of(await next_picture(), is_violet)
	var count: int = field.get_counters().drawn_plants
	var memory: int = field.get_statistics().memory
	species.plant_distance = 2.0
	await drawn()
	var image := await next_picture()
	save(image, "plants_far")
	print("    violet: near %.4f, as pictures %.4f; %d plants" % [near, share_of(image, is_violet), count])
	assert_greater(count, 100)
	assert_eq(field.get_counters().drawn_plants, 0)
	assert_eq(field.get_counters().drawn_impostors, count)
	assert_greater(share_of(image, is_violet), 0.5 * near)
	assert_less(share_of(image, is_violet), 1.3 * near)
	species.plant_mesh = null
	await drawn()
	assert_eq(share_of(await next_picture(), is_violet), 0.0)
	print("    %d bytes for plants" % [memory - int(field.get_statistics().memory)])
	assert_greater(memory - int(field.get_statistics().memory), count * 80)  # instances alone
	assert_less(memory - int(field.get_statistics().memory), 2 * count * 80 + PICTURES + 50000)


## Returns the mean change of a pixel by the shadows of plants, and by those of blades without a mesh.
func shades(species: GrassSpecies, mesh: Mesh, picture_name: String) -> Vector2:
	var field := add_plants([species], {soil_enabled = true})
	var lamp: DirectionalLight3D = viewport.find_children("*", "DirectionalLight3D", true, false)[0]
	lamp.shadow_enabled = true
	lamp.directional_shadow_max_distance = 20.0
	var shade := Vector2.ZERO
	for of_blades in 2:
		species.plant_mesh = null if of_blades else mesh
		field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		var without := await picture()
		field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON
		var image := await picture()
		shade[of_blades] = difference(without, image).y
		if not of_blades:
			save(image, picture_name)
	print("    shadows change pixels in the mean by %.4f, those of blades by %.4f" % [shade.x, shade.y])
	return shade


func test_plants_cast_shadows() -> void:
	var shade := await shades(plant(1.0), lollipop(0.2), "plants_shadow")
	assert_greater(shade.x, 0.001)
	assert_greater(shade.x, 2.0 * shade.y)


func test_the_blade_of_a_near_plant_casts_no_shadow() -> void:
	var gradient := Gradient.new()  # the shaders of species stay, whatever else it has
	var wide := plant(1.0, {width_min = 0.08, width_max = 0.08, gradient = gradient})
	var shade := await shades(wide, lollipop(0.01), "plants_shadow_thin")
	assert_greater(shade.y, 0.001)
	assert_less(shade.x, 0.4 * shade.y)


## Returns the outline of a frond in a few triangles: the preset's own would be drawn near the eye alone in so dense a stand.
func simple_fern() -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for leaflet in 6:
		var y := 0.2 + 0.13 * leaflet
		for side: float in [-0.3, 0.3]:
			for corner: Vector3 in [Vector3(0, y, 0), Vector3(side * (1.1 - y), y + 0.12, 0.03), Vector3(0, y + 0.14, 0)]:
				tool.set_normal(Vector3(0, 0, 1))
				tool.add_vertex(corner)
	var mesh := tool.commit()
	var material := StandardMaterial3D.new()
	material.albedo_color = GREEN
	mesh.surface_set_material(0, material)
	return mesh


## A dense stand of ferns, as a walker sees it.
func test_plants_that_others_hide_are_not_drawn() -> void:
	var fern: GrassSpecies = load("res://addons/grass_field/presets/fern.tres").duplicate()
	fern.plant_mesh = simple_fern()
	var stand := {size = Vector2(10, 20), density = 40.0, soil_enabled = true, pixels_min = 0.0}
	var field := add_plants([fern], stand)
	look(Vector3(0, 1.7, 9.0), Vector3(0, 0.5, 2.0))
	await drawn()
	var all := await next_picture()
	save(all, "plants_all")
	var count: int = field.get_counters().drawn_plants
	field.pixels_min = ClassDB.class_get_property_default_value(&"GrassField", &"pixels_min")
	await drawn()
	var image := await next_picture()
	save(image, "plants_in_sight")
	var left: int = field.get_counters().drawn_plants
	var off := difference(all, image)
	print("    %d plants, %d in sight; mean colour %s and %s, mean difference %.4f" % [count, left, mean(all), mean(image), off.y])
	assert_less(left, 0.8 * count)
	assert_less(absf(mean(image).get_luminance() - mean(all).get_luminance()), 0.01)
	field.backend = GrassField.BACKEND_CPU
	await drawn()
	assert_eq(field.get_counters().drawn_plants, left)
