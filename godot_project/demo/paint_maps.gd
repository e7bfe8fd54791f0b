# SPDX-License-Identifier: MIT
## Paints the maps of the demo's places again, with the strokes that a level designer would draw:
##   godot --headless --path godot_project --script res://demo/paint_maps.gd
extends SceneTree

const PLACES: Array[String] = ["meadow", "lawn", "reeds"]
const Lawn := preload("res://demo/lawn.gd")
const Trail := preload("res://demo/trail.gd")

var _map: GrassMap


func _initialize() -> void:
	for place in PLACES:
		_paint.call_deferred(place)
	quit.call_deferred()


func _paint(p_name: String) -> void:
	var path := "res://demo/%s.grassmap" % p_name
	_map = GrassMap.new()
	if not FileAccess.file_exists(path):
		ResourceSaver.save(_map, path)  # the scene names it
	var place: Node3D = (load("res://demo/%s.tscn" % p_name) as PackedScene).instantiate()
	place.process_mode = Node.PROCESS_MODE_DISABLED
	root.add_child(place)
	var field: GrassField = place.get_node("Field")
	field.map = _map
	if place.has_node("Terrain"):
		var terrain: StaticBody3D = place.get_node("Terrain")
		field.bake_ground_from(terrain.shape, terrain.global_transform)
	call("_paint_" + p_name, place)
	var error := ResourceSaver.save(_map, path)
	print("%s: %s, %d bytes" % [path, error_string(error), FileAccess.get_file_as_bytes(path).size()])
	place.free()


func _paint_meadow(place: Node3D) -> void:
	_map.base_density = 1.0
	for at: Array in [[-20, -8], [8, 20], [24, 2]]:
		_draw(GrassBrush.TOOL_TINT, [at], {color = Color(0.52, 0.5, 0.2), radius = 7.0, hardness = 0.1, strength = 0.4})
	_draw(GrassBrush.TOOL_HEIGHT, [[-30, -30], [-10, -34], [10, -30], [30, -34]], {target = 0.55, radius = 9.0, hardness = 0.2})
	_draw(GrassBrush.TOOL_COMB, [[-12, -6], [0, -10], [12, -12]], {radius = 5.0, hardness = 0.2, strength = 0.6})
	_draw(GrassBrush.TOOL_SPECIES, [[-9, 16], [-4, 15], [2, 18]], {species = 3, radius = 1.0})
	_wear(place.get_node("Path").curve, place, 1, 0.0)
	_draw(
		GrassBrush.TOOL_ERASE,
		[[-40, -40], [40, -40], [40, -20], [-40, -20], [-40, 0], [40, 0], [40, 20], [-40, 20], [-40, 40], [40, 40]],
		{radius = 16.0, slope_min = 34.0, strength = 0.5}
	)  # thin where it is steep


func _paint_lawn(_place: Node3D) -> void:
	_map.base_density = 1.0
	var half_length := Lawn.HALF + 1.0
	for lane in range(-1, Lawn.LANES + 1):
		var lane_at := Lawn.place_of(lane, 0.0).z
		_draw(GrassBrush.TOOL_SPECIES, [[-half_length, lane_at], [half_length, lane_at]], {species = 2, radius = 0.5 * Lawn.LANE})
	for lane in Lawn.MOWN:
		var ends := [Lawn.place_of(lane, -0.3), Lawn.place_of(lane, 2.0 * Lawn.HALF + 0.3)]
		_draw(GrassBrush.TOOL_CUT, ends, {cut_height = 0.06, radius = 0.5 * Lawn.LANE})
		_draw(GrassBrush.TOOL_COMB, ends, {radius = 0.5 * Lawn.LANE, hardness = 0.8})
	_draw(GrassBrush.TOOL_ERASE, [[12.5, -9]], {radius = 0.9, hardness = 0.4})


func _paint_reeds(place: Node3D) -> void:
	var everywhere: Array = []
	for row in 17:
		for side: int in [-30, 30] if row % 2 == 0 else [30, -30]:
			everywhere.append([side, 4 * row - 32])
	_draw(GrassBrush.TOOL_PAINT, everywhere, {radius = 4.0, height_min = -0.6})
	_draw(GrassBrush.TOOL_SPECIES, everywhere, {species = 2, radius = 4.0, height_min = -0.6, height_max = 0.1})
	_draw(GrassBrush.TOOL_DENSITY, everywhere, {target = 0.4, radius = 4.0, height_min = -0.6, height_max = 0.0})
	var landing := Curve3D.new()
	landing.add_point(Vector3(-3, 0, -5))
	landing.add_point(Vector3(-4, 0, 12), Vector3(1, 0, -5), Vector3(-1, 0, 5))
	landing.add_point(Vector3(-15, 0, 31))
	_wear(landing, place, 0, 16.0)


## A path along a curve, with a species beside it, which gets lost within `fade` metres of its end.
func _wear(curve: Curve3D, place: Node3D, species: int, fade: float) -> void:
	var trail := Trail.new()
	trail.points = Trail.points_of(curve)
	trail.species = species
	trail.fade = fade
	var size: Vector2 = place.get_node("Field").size
	trail.wear(_map, Rect2(-0.5 * size, size))


## A stroke through points of the field's plane, [x, z] or Vector3.
func _draw(tool: GrassBrush.Tool, points: Array, properties: Dictionary) -> void:
	var brush := GrassBrush.new()
	brush.tool = tool
	brush.strength = 1.0
	brush.hardness = 1.0
	for property: String in properties:
		brush.set(property, properties[property])
	var places := points.map(
		func(point: Variant) -> Vector2: return Vector2(point.x, point.z) if point is Vector3 else Vector2(point[0], point[1])
	)
	for i in places.size():
		_map.stroke(brush, places[maxi(i - 1, 0)], places[i])
