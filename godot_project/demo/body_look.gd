# SPDX-License-Identifier: MIT
## How thrown bodies look. All but stones have one mesh for each of a few colours, 1 m in size, which bodies scale.
extends RefCounted

enum Kind { BALL, CRATE, LOG, BALE, STONE }

const Mould := preload("res://demo/walk/mould.gd")
const KINDS := 5
const COLORS := 5
const BALL := 0.5  # metres: its radius
const CRATE := Vector3(1.0, 0.6, 0.8)
const LOG := Vector2(0.3, 1.6)  # radius and length
const BALE := Vector2(0.45, 0.7)  # radius and length
## In place of those that a ball had for itself.
const STRIPES: Array[Color] = [
	Color(0.6, 0.17, 0.12), Color(0.74, 0.52, 0.16), Color(0.15, 0.28, 0.44), Color(0.72, 0.7, 0.64), Color(0.2, 0.33, 0.24)
]
const LEATHER := Color(0.76, 0.73, 0.66)
const WOOD: Array[Color] = [
	Color(0.58, 0.44, 0.29), Color(0.65, 0.52, 0.36), Color(0.51, 0.42, 0.31), Color(0.58, 0.55, 0.48), Color(0.46, 0.32, 0.21)
]
const BARK: Array[Color] = [
	Color(0.35, 0.29, 0.23), Color(0.42, 0.36, 0.30), Color(0.30, 0.24, 0.20), Color(0.49, 0.45, 0.41), Color(0.38, 0.29, 0.21)
]
const HAY: Array[Color] = [
	Color(0.66, 0.56, 0.3), Color(0.6, 0.54, 0.31), Color(0.7, 0.6, 0.36), Color(0.55, 0.5, 0.27), Color(0.64, 0.5, 0.27)
]
const STONES: Array[Color] = [
	Color(0.46, 0.45, 0.42), Color(0.52, 0.49, 0.44), Color(0.4, 0.4, 0.4), Color(0.55, 0.51, 0.46), Color(0.44, 0.41, 0.36)
]
const IRON := Color(0.27, 0.25, 0.24)
const ROPE := Color(0.34, 0.3, 0.2)

static var _made := {}  # meshes, by kind and colour


static func mesh(kind: Kind, color: int) -> ArrayMesh:
	var key := Vector2i(kind, color)
	if key not in _made:
		var mould := Mould.new()
		mould.dirt = Vector2(-4.0, 2.2)  # a little everywhere
		match kind:
			Kind.BALL:
				_add_ball(mould, STRIPES[color])
			Kind.CRATE:
				_add_crate(mould, WOOD[color])
			Kind.LOG:
				_add_log(mould, BARK[color], WOOD[color])
			Kind.BALE:
				_add_bale(mould, HAY[color])
		_made[key] = mould.commit()
	return _made[key]


static func stone(points: PackedVector3Array, color: int) -> ArrayMesh:
	var mould := Mould.new()
	mould.grain = Vector2(0.0, 0.5)
	mould.paint(STONES[color], 0.9)
	mould.hull(points)
	return mould.commit()


static func _add_ball(mould: Mould, color: Color) -> void:
	for i in 8:
		mould.paint(color if i % 2 else LEATHER, 0.45)
		mould.gore(BALL, TAU * i / 8.0, TAU * (i + 1) / 8.0)
	mould.paint(IRON, 0.6)
	for end: float in [-1.0, 1.0]:
		mould.disc(0.1 * BALL, 0.02, Mould.at(Vector3(0.0, 0.995 * end * BALL, 0.0)))


## Planks along x and z around a dark inside, with a frame of boards.
static func _add_crate(mould: Mould, color: Color) -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 3
	mould.paint(0.3 * color, 1.0)
	mould.box(CRATE - 0.09 * Vector3.ONE, Mould.at(Vector3.ZERO))
	mould.grain = Vector2(1.0, 0.45)
	for side: float in [-1.0, 1.0]:
		for row in 4:
			_shade(mould, color, random)
			var along := CRATE.y * ((row + 0.5) / 4.0 - 0.5)
			mould.box(Vector3(CRATE.x - 0.04, 0.24 * CRATE.y, 0.03), Mould.at(Vector3(0.0, along, side * (0.5 * CRATE.z - 0.035))))
			_shade(mould, color, random)
			along = CRATE.z * ((row + 0.5) / 4.0 - 0.5)
			mould.box(Vector3(CRATE.x - 0.04, 0.03, 0.24 * CRATE.z), Mould.at(Vector3(0.0, side * (0.5 * CRATE.y - 0.035), along)))
	mould.grain = Vector2(3.0, 0.45)
	for side: float in [-1.0, 1.0]:
		for row in 4:
			_shade(mould, color, random)
			var along := CRATE.y * ((row + 0.5) / 4.0 - 0.5)
			mould.box(Vector3(0.03, 0.24 * CRATE.y, CRATE.z - 0.04), Mould.at(Vector3(side * (0.5 * CRATE.x - 0.035), along, 0.0)))
	_add_frame(mould, color, random)


static func _add_frame(mould: Mould, color: Color, random: RandomNumberGenerator) -> void:
	for axis in 3:
		mould.grain = Vector2(axis + 1.0, 0.45)
		var u := (axis + 1) % 3
		var v := (axis + 2) % 3
		for corner in 4:
			var at := Vector3.ZERO
			at[u] = (0.5 * CRATE[u] - 0.05) * (1.0 if corner & 1 else -1.0)
			at[v] = (0.5 * CRATE[v] - 0.05) * (1.0 if corner & 2 else -1.0)
			var size := Vector3.ONE * (0.1 - 0.004 * axis)
			size[axis] = CRATE[axis] - 0.01 * axis
			_shade(mould, 0.88 * color, random)
			mould.box(size, Mould.at(at), 0.014)


static func _shade(mould: Mould, color: Color, random: RandomNumberGenerator) -> void:
	mould.paint(color.lerp(Color(0.45, 0.43, 0.4), random.randf_range(0.0, 0.35)) * random.randf_range(0.82, 1.08), 0.85)


static func _add_log(mould: Mould, bark: Color, wood: Color) -> void:
	var half := 0.5 * LOG.y
	mould.grain = Vector2(2.0, 0.7)
	mould.paint(bark, 0.95)
	var thick := 0.96 * LOG.x
	var profile := PackedVector2Array([Vector2(0.72 * thick, 0.03 - half), Vector2(0.84 * thick, 0.06 - half)])
	for i in 7:
		profile.append(Vector2(thick * [0.97, 1.0, 0.95, 0.98, 0.94, 0.99, 0.93][i], lerpf(0.14 - half, half - 0.14, i / 6.0)))
	profile.append_array([Vector2(0.84 * thick, half - 0.06), Vector2(0.72 * thick, half - 0.03)])
	mould.lathe(profile, Mould.at(Vector3.ZERO), 24)
	mould.tube([Vector3(0.7 * thick, 0.2, 0.2 * thick), Vector3(1.2 * thick, 0.36, 0.3 * thick)], 0.05)  # a stump of a branch
	mould.grain = Vector2(0.0, 0.2)
	for end: float in [-1.0, 1.0]:
		for ring in 7:
			mould.paint((1.2 if ring % 2 else 0.95) * wood.lerp(Color(0.7, 0.58, 0.4), 0.5), 0.9)
			var radius := 0.72 * thick * (1.0 - ring / 7.0)
			mould.lathe(_ring(radius, radius - 0.72 * thick / 7.0, end, half - 0.03), Mould.at(Vector3.ZERO), 24)


## A flat ring at the end of a log: outwards below, inwards above, so that it faces out.
static func _ring(outer: float, inner: float, end: float, half: float) -> PackedVector2Array:
	var ring := PackedVector2Array([Vector2(outer, end * half), Vector2(maxf(inner, 0.0), end * half)])
	if end < 0.0:
		ring.reverse()
	return ring


static func _add_bale(mould: Mould, hay: Color) -> void:
	var half := 0.5 * BALE.y
	mould.grain = Vector2(0.0, 0.5)
	mould.paint(hay, 1.0)
	mould.lathe(
		[
			Vector2(0.9 * BALE.x, -half),
			Vector2(0.98 * BALE.x, 0.05 - half),
			Vector2(BALE.x, 0.0),
			Vector2(0.98 * BALE.x, half - 0.05),
			Vector2(0.9 * BALE.x, half)
		],
		Mould.at(Vector3.ZERO),
		28
	)
	mould.grain = Vector2(0.0, 0.5)
	for end: float in [-1.0, 1.0]:
		for turn in 6:  # it is rolled up
			mould.paint((0.9 if turn % 2 else 1.05) * hay, 1.0)
			var outer := 0.9 * BALE.x * (1.0 - turn / 6.0)
			mould.lathe(_ring(outer, outer - 0.15 * BALE.x, end, half), Mould.at(Vector3.ZERO), 28)
	mould.grain = Vector2.ZERO
	mould.paint(ROPE, 0.9)
	for along: float in [-0.55, -0.2, 0.2, 0.55]:
		mould.lathe(
			[
				Vector2(0.99 * BALE.x, along * half - 0.012),
				Vector2(1.01 * BALE.x, along * half),
				Vector2(0.99 * BALE.x, along * half + 0.012)
			],
			Mould.at(Vector3.ZERO),
			28
		)
