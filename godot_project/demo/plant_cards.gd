# SPDX-License-Identifier: MIT
## Draws the cards of the presets wheat, barley and tundra, and writes them into the add-on:
## `godot --headless --path godot_project --script res://demo/plant_cards.gd`. A card is a row of four pictures, each as it stands on a
## blade: ears that stand, bend, nod and lost their grains, or tufts of wool and withered heads.
extends SceneTree

const FOLDER := "res://addons/grass_field/presets/cards/"
const PICTURES := 4
const SIDE := 256  # texels, of a picture
const FINER := 2  # times, that it is drawn larger
const STRAW := Color(0.86, 0.72, 0.44)
const AWN := Color(0.9, 0.79, 0.53)
const HUSK := Color(0.62, 0.47, 0.26)
const GREEN := Color(0.66, 0.67, 0.38)
const WOOL := Color(0.96, 0.95, 0.9)
const BROWN := Color(0.42, 0.28, 0.17)
## Metres: width and height of a card, length of the longest ear, of its grains and of its awns.
const WHEAT := {
	width = 0.07, height = 0.12, ear = 0.09, grain = 0.0145, awn = 0.012, bends = [0.15, 0.5, 0.9, 0.3], lengths = [1.0, 0.9, 0.8, 0.62]
}
const BARLEY := {
	width = 0.11, height = 0.17, ear = 0.085, grain = 0.012, awn = 0.075, bends = [0.2, 0.5, 0.85, 0.35], lengths = [1.0, 0.95, 0.85, 0.7]
}
const TUFT := {width = 0.04, height = 0.045}

var _image: Image
var _dice := RandomNumberGenerator.new()
var _texels: Vector2  # a metre, to the right and down
var _left: float  # texels, where the picture begins


func _init() -> void:
	for plant: String in ["wheat", "barley", "tundra"]:
		_dice.seed = 5
		_image = Image.create_empty(FINER * PICTURES * SIDE, FINER * SIDE, false, Image.FORMAT_RGBA8)
		_image.fill(Color(WOOL if plant == "tundra" else STRAW, 0.0))
		for picture in PICTURES:
			_left = FINER * SIDE * (picture + 0.5)
			match plant:
				"wheat":
					_draw_ear(WHEAT, picture)
				"barley":
					_draw_ear(BARLEY, picture)
				"tundra":
					_draw_tuft(picture)
		_image.resize(PICTURES * SIDE, SIDE, Image.INTERPOLATE_BILINEAR)
		_image.save_png(FOLDER + plant + ".png")
	quit()


## Two rows of grains on both sides of a stalk, and one before it.
func _draw_ear(kind: Dictionary, picture: int) -> void:
	_texels = (FINER * SIDE) * Vector2.ONE / Vector2(kind.width, kind.height)
	var length: float = kind.ear * kind.lengths[picture]
	var bend: float = kind.bends[picture]
	var fresh := STRAW.lerp(GREEN, 0.55 if picture == 3 else 0.0)
	var rows := roundi(length / (0.3 * kind.grain))
	var at := Vector2(-0.1 * length * bend, 0.0)
	var foot := 0.004
	_draw_stroke(at, at + Vector2(0.0, 0.012), 0.0011, 0.0011, HUSK)
	at.y = foot
	for row in rows:
		var along := float(row) / rows
		var way := Vector2.UP.rotated(bend * along) * Vector2(1, -1)
		var size: float = kind.grain * (1.0 - 0.35 * along * along) * _dice.randf_range(0.9, 1.1)
		for side: float in [-1.0, 1.0] if row % 2 else [1.0, -1.0]:
			var out := way.rotated(-side * _dice.randf_range(0.3, 0.5))
			_draw_grain(kind, at, way, out, size, fresh, side)
		if row % 2:
			_draw_grain(kind, at, way, way.rotated(_dice.randf_range(-0.15, 0.15)), 0.85 * size, fresh.lightened(0.08), 0.0)
		at += way * length / rows
	var end := Vector2.UP.rotated(bend) * Vector2(1, -1)
	_draw_grain(kind, at, end, end, 0.8 * kind.grain, fresh, 0.0)


## A grain in its husk, dark at its foot and along one edge, with an awn. ear: the way of the ear there.
func _draw_grain(kind: Dictionary, at: Vector2, ear: Vector2, way: Vector2, size: float, color: Color, side: float) -> void:
	var tint := color.lerp(HUSK, _dice.randf_range(0.0, 0.45))
	var tip := at + way * size
	var awn := way.slerp(ear, 0.7).rotated(_dice.randf_range(-0.1, 0.1))
	_draw_stroke(tip - 0.1 * size * way, tip + awn * kind.awn * _dice.randf_range(0.5, 1.0), 0.00045, 0.0003, AWN)
	_draw_leaf(at, way, size, 0.19 * size, tint, side)


## Fine hairs around a place, that hang a little; withered heads are small and brown.
func _draw_tuft(picture: int) -> void:
	_texels = (FINER * SIDE) * Vector2.ONE / Vector2(TUFT.width, TUFT.height)
	var is_withered := picture == 3
	var at := Vector2(0.0, 0.5 * TUFT.height)
	var reach: float = [0.017, 0.014, 0.012, 0.006][picture]
	_draw_stroke(Vector2.ZERO, at, 0.0007, 0.0006, BROWN)
	for hair in 70 if is_withered else 420:
		var way := Vector2.from_angle(_dice.randf() * TAU) * sqrt(_dice.randf()) * reach
		var light := _dice.randf_range(0.9, 1.05) * (0.97 + 6.0 * way.y)
		var color := BROWN.lightened(0.2 * light) if is_withered else Color(WOOL * minf(light, 1.0), 1.0)
		_draw_stroke(at + 0.4 * way, at + way * Vector2(0.9, 1.0) - Vector2(0.0, 0.3 * reach), 0.0004, 0.0002, color)
	for husk in 5:
		_draw_leaf(at, Vector2.UP.rotated(_dice.randf_range(-0.9, 0.9)) * Vector2(1, -1) * -1.0, 0.004, 0.0006, BROWN, 0.0)


## A pointed oval from `at` along `way`.
func _draw_leaf(at: Vector2, way: Vector2, length: float, half: float, color: Color, side: float) -> void:
	_fill(
		at,
		at + way * length,
		half,
		func(along: float, across: float) -> Color:
			if absf(across) > sqrt(maxf(sin(PI * pow(along, 0.75)), 0.0)):
				return Color(0, 0, 0, 0)
			var light := lerpf(0.72, 1.06, along) * (1.0 - 0.22 * across * across) * (1.0 + 0.12 * across * side)
			return Color(color * light, 1.0)
	)


func _draw_stroke(from: Vector2, to: Vector2, first: float, last: float, color: Color) -> void:
	_fill(
		from,
		to,
		maxf(first, last),
		func(along: float, across: float) -> Color:
			return Color(color, 1.0 if absf(across) * maxf(first, last) < lerpf(first, last, along) else 0.0)
	)


## Draws what lies around a line. look: the colour for the place along the line, 0 to 1, and across it, -1 to 1; transparent: none.
func _fill(from: Vector2, to: Vector2, half: float, look: Callable) -> void:
	var way := (to - from).normalized()
	var length := from.distance_to(to)
	var first := roundi(_left) - FINER * SIDE / 2  # of this picture
	var low := _texel(Vector2(minf(from.x, to.x) - half, maxf(from.y, to.y) + half))
	var high := _texel(Vector2(maxf(from.x, to.x) + half, minf(from.y, to.y) - half))
	for y in range(maxi(low.y, 0), mini(high.y, _image.get_height() - 1) + 1):
		for x in range(maxi(low.x, first), mini(high.x, first + FINER * SIDE - 1) + 1):
			var off := Vector2((x + 0.5 - _left) / _texels.x, (_image.get_height() - y - 0.5) / _texels.y) - from
			var along := off.dot(way) / length
			var across := off.cross(way) / half
			if along >= 0.0 and along <= 1.0 and absf(across) <= 1.0:
				var color: Color = look.call(along, across)
				if color.a > 0.5:
					_image.set_pixel(x, y, color)


func _texel(place: Vector2) -> Vector2i:
	return Vector2i(roundi(_left + place.x * _texels.x), roundi(_image.get_height() - place.y * _texels.y))
