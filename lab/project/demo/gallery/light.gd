# SPDX-License-Identifier: MIT
## The light of a view of the gallery, and other things that the view names: lamps, walls, fog, a decal.
extends Node3D

const Probes := preload("res://demo/gallery/probes.gd")
const Place := preload("res://demo/gallery/place.gd")
const Landscape := preload("res://demo/landscape.gd")
const Sun := preload("res://demo/sun.gd")
const DAY := preload("res://demo/day.tres")
const WALLS := {Vector3(-3.2, 1.3, 1.0): Color(0.75, 0.08, 0.06), Vector3(3.2, 1.3, 1.0): Color(0.85, 0.85, 0.82)}
const LOW := 25.0  # degrees: a lower sun is warm
const WALL := Vector3(0.3, 2.6, 5.0)
const LAMPS := {Vector3(-2.5, 2.2, 1.0): Color(1.0, 0.7, 0.4), Vector3(3.5, 2.2, -3.0): Color(0.7, 0.85, 1.0)}

var _environment: Environment


func _init(view: Dictionary) -> void:
	_environment = Landscape.with_clouds(DAY) if view.sky == "clear" else DAY.duplicate(true)
	var world := WorldEnvironment.new()
	world.environment = _environment
	add_child(world)
	match view.sky:
		"clear":
			add_child(_sun(view.sun))
			if view.sun.x < LOW:
				_set_sky(Color(0.25, 0.41, 0.63), Color(0.94, 0.8, 0.6), 1.0)
		"overcast":
			_set_sky(Color(0.62, 0.65, 0.68), Color(0.78, 0.8, 0.82), 1.0)
		"night":
			_set_sky(Color(0.006, 0.009, 0.02), Color(0.015, 0.02, 0.035), 1.0)
	for what: String in view.with:
		if has_method("_add_" + what):  # all others belong to the place
			call("_add_" + what)


func _set_sky(top: Color, horizon: Color, energy: float) -> void:
	var sky: ProceduralSkyMaterial = _environment.sky.sky_material
	sky.sky_top_color = top
	sky.sky_horizon_color = horizon
	sky.ground_horizon_color = horizon
	sky.ground_bottom_color = 0.5 * horizon
	sky.energy_multiplier = energy
	_environment.fog_light_color = horizon


func _sun(height_and_side: Vector2) -> DirectionalLight3D:
	var sun := DirectionalLight3D.new()
	# It shines along its -Z. Without a turn about Y that is the camera's direction, so the sun is behind the camera.
	sun.rotation_degrees = Vector3(-height_and_side.x, 180.0 - height_and_side.y, 0.0)
	sun.light_color = Color(1, 0.95, 0.85) if height_and_side.x > LOW else Color(1, 0.8, 0.58)
	sun.light_energy = 1.4
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 80.0
	Sun.complete(sun, _environment.sky.sky_material)
	return sun


func _add_lamps() -> void:
	for place: Vector3 in LAMPS:
		var lamp := OmniLight3D.new()
		lamp.position = place
		lamp.light_color = LAMPS[place]
		lamp.light_energy = 4.0
		lamp.omni_range = 9.0
		lamp.shadow_enabled = true
		add_child(lamp)
		add_child(_box(place + Vector3(0, 0.15, 0), Vector3(0.16, 0.16, 0.16), Color(0.9, 0.9, 0.9), LAMPS[place]))
		add_child(_box(Vector3(place.x, 0.5 * place.y, place.z), Vector3(0.06, place.y, 0.06), Color(0.1, 0.1, 0.1)))
	var torch := SpotLight3D.new()
	torch.position = Vector3(1.0, 1.5, 9.5)
	torch.rotation_degrees = Vector3(-12, 14, 0)
	torch.light_energy = 8.0
	torch.spot_range = 18.0
	torch.spot_angle = 16.0
	torch.shadow_enabled = true
	add_child(torch)


func _add_walls() -> void:
	for place: Vector3 in WALLS:
		add_child(_box(place, WALL, WALLS[place]))


func _add_fog() -> void:
	_environment.fog_density = 0.03
	_environment.fog_light_color = Color(0.74, 0.76, 0.78)
	_environment.fog_sun_scatter = 0.25


func _add_volumetric_fog() -> void:
	_environment.volumetric_fog_enabled = true
	_environment.volumetric_fog_density = 0.03
	_environment.volumetric_fog_anisotropy = 0.6


func _add_sdfgi() -> void:
	_environment.sdfgi_enabled = true
	_environment.sdfgi_min_cell_size = 0.1


func _add_voxel_gi() -> void:
	var voxels := VoxelGI.new()
	voxels.size = Vector3(14, 6, 14)
	voxels.position = Vector3(0, 1.5, 1)
	add_child(voxels)
	voxels.ready.connect(func() -> void: voxels.bake.call_deferred(get_parent()))


## Makes five plots, each lit by the light of its own place.
func _add_light_probes() -> void:
	add_child(Probes.new(PackedVector3Array(Place.PLOTS), WALLS, WALL))


func _add_decal() -> void:
	var decal := Decal.new()
	var ring := GradientTexture2D.new()
	ring.fill = GradientTexture2D.FILL_RADIAL
	ring.fill_from = Vector2(0.5, 0.5)
	ring.fill_to = Vector2(1.0, 0.5)
	ring.gradient = Gradient.new()
	ring.gradient.offsets = [0.0, 0.68, 0.72, 0.86, 0.9]
	ring.gradient.colors = [Color(1, 1, 1, 0), Color(1, 1, 1, 0), Color(0.9, 0.1, 0.05), Color(0.9, 0.1, 0.05), Color(1, 1, 1, 0)]
	decal.texture_albedo = ring
	decal.size = Vector3(6, 2, 6)
	decal.position = Vector3(0, 0.5, 2)
	add_child(decal)


func _box(place: Vector3, size: Vector3, color: Color, glow := Color.BLACK) -> MeshInstance3D:
	var box := MeshInstance3D.new()
	box.mesh = BoxMesh.new()
	box.mesh.size = size
	box.position = place
	var material := StandardMaterial3D.new()
	material.albedo_color = color
	material.emission_enabled = glow != Color.BLACK
	material.emission = glow
	box.material_override = material
	box.gi_mode = GeometryInstance3D.GI_MODE_STATIC
	return box
