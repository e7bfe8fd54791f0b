# SPDX-License-Identifier: MIT
## The scene that tools/test/validation.py runs under Vulkan's validation layer: ground, a light with shadows, and moving bodies; with `--
## --field` also fields that use all passes for bodies, maps and species. Messages about the scene without fields come from the engine
## itself.
extends Node3D

const TICKS := 40
const COMPILING := 600.0  # seconds

var _movers: Array[AnimatableBody3D] = []


func _ready() -> void:
	_add_surroundings()
	var box := BoxShape3D.new()
	box.size = Vector3(0.5, 0.1, 0.3)
	var ball := SphereShape3D.new()
	ball.radius = 0.3
	for shape: Shape3D in [ball, box]:
		_add_mover(shape)
	var fields: Array[GrassField] = []
	if "--field" in OS.get_cmdline_user_args():
		fields = [_add_field(-2.5, {}), _add_field(2.5, {map = _hilly_map(), species = _two_species(), soil_enabled = true})]
		await _compiled(fields)
	for tick in TICKS:
		for i in _movers.size():
			_movers[i].position = Vector3(4.0 * sin(0.05 * tick + i), 0.25, 0.3 * i)
		if fields and tick == TICKS / 2:
			fields[0].pool_tiles = 64  # other buffers
			fields[1].paint(GrassBrush.new(), Vector3(2, 0, 0), Vector3(3, 0, 0))
		await get_tree().physics_frame
	await _compiled(fields)
	for tick in TICKS / 2:
		await get_tree().physics_frame
	for field in fields:
		var now := field.get_statistics().merged(field.get_counters())
		print(
			(
				"GRASS-VALIDATION %s: %d steps, %d tiles by the pass for edges, %d by the one without colliders, %d drawn tiles"
				% [now.backend, now.steps, now.edge_tile_steps, now.free_tile_steps, now.drawn_tiles]
			)
		)
		field.free()
	await get_tree().process_frame
	print("GRASS-VALIDATION done")
	get_tree().quit()


func _add_surroundings() -> void:
	var camera := Camera3D.new()
	camera.position = Vector3(0, 3, 7)
	camera.rotation.x = -0.4
	add_child(camera)
	var light := DirectionalLight3D.new()
	light.rotation = Vector3(-0.9, 0.5, 0)
	light.shadow_enabled = true
	add_child(light)
	var floor_mesh := MeshInstance3D.new()
	floor_mesh.mesh = PlaneMesh.new()
	floor_mesh.mesh.size = Vector2(20, 20)
	add_child(floor_mesh)


func _add_mover(shape: Shape3D) -> void:
	var body := AnimatableBody3D.new()
	body.sync_to_physics = false
	var node := CollisionShape3D.new()
	node.shape = shape
	body.add_child(node)
	add_child(body)
	_movers.append(body)


func _add_field(x: float, properties: Dictionary) -> GrassField:
	var field := GrassField.new()
	field.size = Vector2(4, 4)
	field.position.x = x
	for property: String in properties:
		field.set(property, properties[property])
	add_child(field)
	return field


func _two_species() -> Array[GrassSpecies]:
	var species: Array[GrassSpecies] = [GrassSpecies.new(), GrassSpecies.new()]
	species[1].natural_frequency = 2.0
	return species


func _hilly_map() -> GrassMap:
	var map := GrassMap.new()
	map.base_density = 1.0
	var heights := Image.create_empty(8, 8, false, Image.FORMAT_RF)
	for x in 8:
		for z in 8:
			heights.set_pixel(x, z, Color(0.02 * x, 0, 0))
	map.set_ground(heights, Rect2(-2, -2, 4, 4))
	return map


## Waits for frames until the driver has compiled all passes of the fields.
func _compiled(fields: Array[GrassField]) -> void:
	var deadline := Time.get_ticks_msec() + COMPILING * 1000
	while fields.any(func(field: GrassField) -> bool: return field.get_statistics().waiting or field.get_statistics().compiling > 0):
		if Time.get_ticks_msec() > deadline:
			return
		OS.delay_msec(50)  # frames only take the time of the threads that compile, and the layer looks at each
		await get_tree().process_frame
