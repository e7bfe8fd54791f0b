# SPDX-License-Identifier: MIT
## The frames during a change of a field: how many pass until it shows, the longest time that the field worked in one of them (`build_ms`),
## and the longest frame, beside the longest one without a change. Nothing is drawn, so the times do not include the renderer's pipelines,
## but they include making shaders.
extends Node3D

const SIDE := 500.0  # metres: 64 million blades
const PAINTED: Array[float] = [-192.0, -64.0, 64.0, 192.0]  # metres: middles of strokes along each side, which cover it all
const STILL := 20  # frames in which nothing changes, before each change

var _field: GrassField
var _painted: GrassMap
var _last := 0  # microseconds


func run(_p_software: bool) -> Array[PackedStringArray]:
	get_viewport().disable_3d = true
	_field = GrassField.new()
	_field.size = Vector2(SIDE, SIDE)
	var rows: Array[PackedStringArray] = [["change", "frames", "makings", "build_ms", "longest_frame_ms", "still_frame_ms"]]
	rows.append(await _measure("the first field", func() -> void: add_child(_field)))
	var changes: Dictionary[String, Callable] = {
		"size": func() -> void: _field.size = Vector2(SIDE - 1.0, SIDE),
		"density": func() -> void: _field.density = 250.0,
		"seed": func() -> void: _field.seed = 1,
		"clumps": func() -> void: _field.clump_size = 2.0,
		"patch": func() -> void: _field.species = [_species(0.6)],
		"pool": func() -> void: _field.pool_tiles = 2048,
		"a map, all grass": func() -> void: _field.map = _map(1.0, false),
		"another map, painted": func() -> void: _field.map = _painted,
		"another map, painted, again": func() -> void: _field.map = _painted.duplicate(),
		"no map": func() -> void: _field.map = null,
		"the first species": func() -> void: _field.species = [GrassSpecies.new(), GrassSpecies.new()],
		"two species with patches": func() -> void: _field.species = [_species(0.5), _species(0.7)],
		"blades of one of them": func() -> void: _field.species[0].patch.length_max = 0.9,
		"a map, too": func() -> void: _field.map = _painted,
		"its grass cleared and restored": _clear_and_restore,
		"no species": func() -> void: _field.species = [],
	}
	for change in changes:
		_painted = _map(1.0, true)
		rows.append(await _measure(change, changes[change]))
		print(", ".join(rows[-1]))
	_field.queue_free()
	get_viewport().disable_3d = false
	return rows


func _measure(p_name: String, p_change: Callable) -> PackedStringArray:
	var still := 0.0
	await _frame()
	for i in STILL:
		still = maxf(still, await _frame())
	var before: int = _field.get_counters().makings if _field.is_inside_tree() else 0
	p_change.call()
	_last = Time.get_ticks_usec()
	var longest := 0.0
	var frames := 0
	while frames == 0 or _field.get_statistics().waiting or _field.get_counters().map_waiting > 0:
		longest = maxf(longest, await _frame())
		frames += 1
	for i in 2:  # what the renderer does with it
		longest = maxf(longest, await _frame())
	var now := _field.get_counters()
	return [p_name, str(frames), str(now.makings - before), "%.2f" % now.build_ms, "%.1f" % longest, "%.1f" % still]


## Returns milliseconds from the end of the last call to the next frame.
func _frame() -> float:
	await get_tree().process_frame
	var before := _last
	_last = Time.get_ticks_usec()
	return (_last - before) * 1e-3


## Does the same as the undo of a large fill.
func _clear_and_restore() -> void:
	var all := _field.map.take_snapshot()
	_field.map.clear()
	_field.map.restore_snapshot(all)


func _patch(p_length: float) -> GrassPatch:
	var patch := GrassPatch.new()
	patch.length_max = p_length
	return patch


func _species(p_length: float) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = _patch(p_length)
	return species


func _map(p_density: float, p_painted: bool) -> GrassMap:
	var map := GrassMap.new()
	map.base_density = p_density
	if p_painted:
		var brush := GrassBrush.new()
		brush.tool = GrassBrush.TOOL_HEIGHT
		brush.radius = 64.0
		brush.target = 0.6
		for x in PAINTED:
			for z in PAINTED:
				map.stroke(brush, Vector2(x, z), Vector2(x, z))
	return map
