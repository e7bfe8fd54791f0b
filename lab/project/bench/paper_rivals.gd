# SPDX-License-Identifier: MIT
## Compares a GrassField with other ways to draw grass in Godot, with as many blades, from the same place, under the same sun: one MultiMesh
## with an instance a blade (7 and 15 segments), MultiMeshes by tile that are switched by distance, and our own re-creation of the way
## in which GodotGrass draws (rings of tiles).
extends Node3D

const FrameTimer := preload("res://bench/frame_timer.gd")
const RivalGrass := preload("res://bench/rival_grass.gd")
const Scenery := preload("res://bench/scenery.gd")
const Table := preload("res://bench/table.gd")

const SIDES: Array[float] = [32.0, 64.0, 128.0, 256.0]  # metres: 0.25 to 16 million blades
const KINDS: Array[String] = ["field", "rings", "tiles", "multimesh 7", "multimesh 15"]
const MOST_OF_15 := 64.0  # metres: a larger field of blades with 15 segments takes a card seconds a frame
const SECONDS := 0.6  # of drawing, at most, for a row


func run(p_pictures: String, r_table: Table, p_software: bool) -> void:
	r_table.columns(["kind", "blades", "view", "shadows", "gpu_ms", "cull_ms", "wall_ms", "outcome"])
	var timer := FrameTimer.new(get_viewport(), p_software)
	timer.seconds = SECONDS
	get_viewport().msaa_3d = Viewport.MSAA_DISABLED
	var camera := Scenery.add_camera(self)
	var sun := Scenery.add_sun(self, false)
	var ground := MeshInstance3D.new()  # the field draws its own
	ground.mesh = PlaneMesh.new()
	ground.material_override = StandardMaterial3D.new()
	ground.material_override.albedo_color = Color(0.22, 0.2, 0.12)
	add_child(ground)
	for side: float in [8.0] if p_software else SIDES:
		ground.mesh.size = Vector2(side, side)
		for kind in KINDS:
			if kind == "multimesh 15" and side > MOST_OF_15:
				continue
			var grass := _make(kind, side)
			ground.visible = kind != "field"
			for view: String in ["eye", "above"]:
				FrameTimer.look(camera, view, side)
				for shadows: bool in [false, true]:
					sun.shadow_enabled = shadows
					var times := await timer.measure(camera)
					r_table.add(_row(grass, kind, view, shadows, times))
					if p_pictures and shadows and side < 100.0:
						get_viewport().get_texture().get_image().save_png(
							p_pictures.path_join("rival_%s_%s_%d.png" % [kind.replace(" ", "_"), view, side])
						)
			grass.queue_free()
			await get_tree().process_frame


func _make(p_kind: String, p_side: float) -> Node3D:
	if p_kind == "field":
		var field := GrassField.new()
		field.size = Vector2(p_side, p_side)
		field.density = RivalGrass.DENSITY
		field.measure_time = true
		add_child(field)
		return field
	var grass := RivalGrass.new()
	add_child(grass)
	if p_kind == "tiles":
		grass.make_tiled(p_side, RivalGrass.TILE, RivalGrass.LEVELS)
	elif p_kind == "rings":
		grass.make_tiled(p_side, RivalGrass.RING_TILE, RivalGrass.RINGS)
		grass.flatten(Vector3(0.0, 0.0, 0.4 * p_side), 1.0)
	else:
		grass.make_plain(p_side, p_kind.to_int())
	return grass


func _row(p_grass: Node3D, p_kind: String, p_view: String, p_shadows: bool, p_times: Dictionary) -> Dictionary:
	var row := {
		kind = p_kind,
		view = p_view,
		shadows = "on" if p_shadows else "off",
		gpu_ms = p_times.gpu_ms,
		wall_ms = p_times.wall_ms,
		cull_ms = 0.0
	}
	if p_kind == "field":
		var statistics: Dictionary = p_grass.get_statistics()
		row.blades = statistics.blades
		row.cull_ms = statistics.cull_ms
		if statistics.drawn_blades == 0:
			row.outcome = "nothing was drawn"
	else:
		row.blades = p_grass.blades
		if p_grass.error:
			row.outcome = p_grass.error
	return row
