# SPDX-License-Identifier: MIT
## Measures the walk on this GPU: the time to draw a frame, whole and with one part left out at a time. Started with
## `-- --parts FILE`, which is written as CSV (lab/results/walk.md).
extends RefCounted

const Scenery := preload("res://demo/walk/country.gd")
const SETTLE := 30  # frames after each change
const FRAMES := 40  # whose median counts

var _walk: Node3D
var _viewport: Viewport
var _whole := 0.0
var _gone: Array[String] = []  # presets


func _init(p_walk: Node3D) -> void:
	_walk = p_walk
	_viewport = p_walk.get_viewport()


func measure(p_path: String) -> void:
	_walk.panel.visible = false
	RenderingServer.viewport_set_measure_render_time(_viewport.get_viewport_rid(), true)
	var file := FileAccess.open(p_path, FileAccess.WRITE)
	file.store_line("# %s, %s" % [RenderingServer.get_video_adapter_name(), RenderingServer.get_current_rendering_method()])
	file.store_csv_line(["left_out", "draw_ms", "less_ms", "blades", "triangles", "plants"])
	var country: Node3D = _walk.country
	var near: GrassField = country.field
	var far: Array[GrassField] = country.fields.filter(func(field: GrassField) -> bool: return field != near)
	var sun: DirectionalLight3D = _walk.get_node("Sun")
	var cases: Array[Array] = [
		["nothing", func() -> void: pass, func() -> void: pass],
		["MSAA", func() -> void: _viewport.msaa_3d = Viewport.MSAA_DISABLED, func() -> void: _viewport.msaa_3d = Viewport.MSAA_2X],
		["shadows", func() -> void: sun.shadow_enabled = false, func() -> void: sun.shadow_enabled = true],
		["shadows of grass", _cast.bind(near, false), _cast.bind(near, true)],
		["far fields", _show.bind(far, false), _show.bind(far, true)],
		["the near field", _show.bind([near], false), _show.bind([near], true)],
		["all grass", _show.bind(country.fields, false), _show.bind(country.fields, true)],
		["the sun", func() -> void: sun.light_energy = 0.0, func() -> void: sun.light_energy = 1.5],
		["hook", _hook.bind(country.fields, null), _hook.bind(country.fields, load(Scenery.WEATHER))],
		["meshes of plants", _leave.bind(near, Scenery.WITH_MESH), func() -> void: pass],
		["seed heads, too", _leave.bind(near, ["hay_meadow"]), func() -> void: pass],
		["daisies, too", _leave.bind(near, ["daisy"]), func() -> void: pass],
		["the map, too", func() -> void: near.map = null, func() -> void: pass],
	]
	for case in cases:
		case[1].call()
		var row := await _row(case[0])
		file.store_csv_line(row)
		print(", ".join(row))
		case[2].call()


func _row(p_name: String) -> PackedStringArray:
	await _wait()
	var times: Array[float] = []
	for i in FRAMES:
		await RenderingServer.frame_post_draw
		times.append(RenderingServer.viewport_get_measured_render_time_gpu(_viewport.get_viewport_rid()))
	times.sort()
	var ms := times[FRAMES >> 1]
	_whole = ms if _whole == 0.0 else _whole
	var blades := 0
	var triangles := 0
	var plants := 0
	for field: GrassField in _walk.country.fields:
		var facts := field.get_statistics().merged(field.get_counters())
		blades += facts.drawn_blades
		triangles += facts.drawn_triangles + facts.shadow_triangles
		plants += facts.get("drawn_plants", 0)
	return [p_name, "%.2f" % ms, "%.2f" % (_whole - ms), str(blades), str(triangles), str(plants)]


## Waits until no field waits for anything, and a little longer.
func _wait() -> void:
	for i in 600:
		await RenderingServer.frame_post_draw
		var facts: Dictionary = _walk.country.field.get_statistics().merged(_walk.country.field.get_counters())
		if i > SETTLE and not (facts.waiting or facts.map_waiting > 0 or facts.compiling > 0):
			return


func _show(p_fields: Array, p_visible: bool) -> void:
	for field: GrassField in p_fields:
		field.visible = p_visible


func _cast(p_field: GrassField, p_casts: bool) -> void:
	p_field.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_ON if p_casts else GeometryInstance3D.SHADOW_CASTING_SETTING_OFF


func _hook(p_fields: Array, p_hook: ShaderInclude) -> void:
	for field: GrassField in p_fields:
		field.surface_hook = p_hook


## Removes the species of these presets.
func _leave(p_field: GrassField, p_presets: Array) -> void:
	_gone.append_array(p_presets)
	var names: Array = Scenery.SPECIES.keys()
	names = names.filter(func(each: String) -> bool: return each not in _gone)
	var species: Array[GrassSpecies] = []
	for preset: String in names:
		species.append((load(Scenery.PRESETS % preset) as GrassSpecies).duplicate())
		species[-1].share = Scenery.SPECIES[preset]
	p_field.species = species
