# SPDX-License-Identifier: MIT
## The longest frame after each change of a drawn field of 64 million blades, beside the median of the frames before: what a player would
## feel. It includes making the renderer's pipelines, so a first run (a driver with an empty cache) and a second one differ.
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const Measure := preload("res://bench/measure.gd")
const Scenery := preload("res://bench/scenery.gd")
const SIDE := 500.0  # metres
const STILL := 30  # frames before each change
const AFTER := 30  # frames in which its consequences are looked for, once the field waits for nothing

var _field: GrassField
var _camera: Camera3D
var _side := SIDE
var _still := STILL
var _after := AFTER
var _last := 0  # microseconds


func run(p_software: bool) -> Array[PackedStringArray]:
	if p_software:
		_side = 8.0
		_still = 1
		_after = 2
	_camera = Scenery.add_camera(self)
	FrameTimer.look(_camera, "eye", _side)
	Scenery.add_ground(self)
	Scenery.add_sun(self, true)
	_field = GrassField.new()
	_field.size = Vector2.ONE * _side
	var rows: Array[PackedStringArray] = [["change", "frames", "median_ms", "longest_ms", "over_ms"]]
	var changes: Dictionary[String, Callable] = {
		"nothing": func() -> void: pass,
		"a bare shader": _show_bare,
		"the first field": func() -> void: add_child(_field),
		"nothing again": func() -> void: pass,
		"a camera that turns": func() -> void: _camera.rotation.y = 1.0,
		"the first ball": _drop.bind(SphereShape3D.new()),
		"the first box": _drop.bind(BoxShape3D.new()),
		"wind": func() -> void: _field.wind_speed = 6.0,
		"size": func() -> void: _field.size = Vector2(_side - 1.0, _side),
		"density": func() -> void: _field.density = 250.0,
		"blades": func() -> void: _field.species = [_species(0.6)],
		"method": func() -> void: _field.method = GrassField.METHOD_PBD,
		"pool": func() -> void: _field.pool_tiles = 2048,
		"the first map": _map,
		"cuts": _mow,
		"the first species": func() -> void: _field.species = [GrassSpecies.new(), GrassSpecies.new()],
		"the first force": _blow,
	}
	for change in changes:
		rows.append(await _measure(change, changes[change]))
		print(", ".join(rows[-1]))
	for node in get_children():
		node.queue_free()
	return rows


func _measure(p_name: String, p_change: Callable) -> PackedStringArray:
	var still: Array[float] = []
	await _frame()
	for i in _still:
		still.append(await _frame())
	p_change.call()
	var frames := 0
	var left := _after
	var longest := 0.0
	while left > 0:
		longest = maxf(longest, await _frame())
		frames += 1
		left -= 0 if _waits() and frames < 3000 else 1
	var median := Measure.median(still)
	return [p_name, str(frames), "%.2f" % median, "%.2f" % longest, "%.2f" % (longest - median)]


func _waits() -> bool:
	if not _field.is_inside_tree():
		return false
	var now := _field.get_statistics().merged(_field.get_counters())
	return now.waiting or now.map_waiting > 0 or now.compiling > 0


## Returns milliseconds since the last frame; the camera moves slowly, since a still picture is not culled again.
func _frame() -> float:
	_camera.position.y += 1e-4
	await RenderingServer.frame_post_draw
	var before := _last
	_last = Time.get_ticks_usec()
	return (_last - before) * 1e-3


## The engine's own time for a new material, with a shader that does nothing.
func _show_bare() -> void:
	var material := ShaderMaterial.new()
	material.shader = Shader.new()
	material.shader.code = "shader_type spatial;"
	var look := MeshInstance3D.new()
	look.mesh = QuadMesh.new()
	look.material_override = material
	look.position = _camera.position + 3.0 * -_camera.basis.z
	add_child(look)


func _drop(p_shape: Shape3D) -> void:
	var body := RigidBody3D.new()
	var shape := CollisionShape3D.new()
	shape.shape = p_shape
	body.add_child(shape)
	body.position = Vector3(0.0, 0.6, 0.42 * _side)
	body.linear_velocity = Vector3(2.0, 0.0, 0.0)
	add_child(body)


func _mow() -> void:
	var deck := CylinderShape3D.new()
	deck.radius = 2.0
	deck.height = 1.0
	_field.cut(deck, Transform3D(Basis(), Vector3(0.0, 0.6, 0.42 * _side)))


func _blow() -> void:
	var force := GrassForce3D.new()
	force.position = Vector3(0.0, 1.0, 0.42 * _side)
	add_child(force)


func _species(p_length: float) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.patch.length_max = p_length
	return species


func _map() -> void:
	var map := GrassMap.new()
	map.base_density = 1.0
	_field.map = map
