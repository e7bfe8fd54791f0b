# SPDX-License-Identifier: MIT
## The hills that all stand-ins for terrains share, and the edits on them.
extends RefCounted

var rough := 0.0  # metres by which heights at whole metres differ from the hills at most
var bump := 0.0  # metres more within `bump_area`
var bump_area := Rect2()
var hole := Rect2()  # x, z; without ground
var grass := Rect2()  # x, z; here texture 1 shows, elsewhere texture 0
var path := Rect2()  # x, z; here texture 2 shows over the others, by 3/4
var painted := Rect2()  # x, z; here the ground has `color`
var color := Color(0.8, 0.2, 0.1)


func height(x: float, z: float) -> float:
	var off := rough * (hash(Vector2i(Vector2(x, z).round())) % 1000 / 1000.0)
	return off + 12.0 + 2.0 * sin(0.1 * x) + 0.15 * z + (bump if bump_area.has_point(Vector2(x, z)) else 0.0)


func has_ground(x: float, z: float) -> bool:
	return not hole.has_point(Vector2(x, z))


## White where nobody painted, as in the colour maps of Terrain3D and HTerrain.
func color_at(x: float, z: float) -> Color:
	return color if painted.has_point(Vector2(x, z)) else Color.WHITE


## Base, overlay and blend, as Terrain3D returns them.
func texture(x: float, z: float) -> Vector3:
	var place := Vector2(x, z)
	return Vector3(1 if grass.has_point(place) else 0, 2, 0.75 if path.has_point(place) else 0.0)
