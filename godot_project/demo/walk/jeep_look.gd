# SPDX-License-Identifier: MIT
## How the jeep looks: its body with all that is fixed to it, and a wheel. Ahead is +z; lengths are metres.
extends RefCounted

const Mould := preload("res://demo/walk/mould.gd")
const GREEN := Color(0.31, 0.335, 0.23)
const CREAM := Color(0.78, 0.74, 0.62)
const BLACK := Color(0.2, 0.2, 0.2)
const RUBBER := Color(0.19, 0.19, 0.185)
const STEEL := Color(0.55, 0.55, 0.53)
const RUST := Color(0.33, 0.25, 0.2)
const LEATHER := Color(0.33, 0.24, 0.17)
const WIDE := 0.72  # from the middle to the sides
const DIRT := Vector2(0.25, 1.15)  # heights above the body's origin with all and with no dirt
const ARCH := 0.5  # radius of the opening over a wheel
const AXLE := Vector2(1.25, 0.44)  # ahead and up
const REAR := -1.78
const LUGS := 30  # of a tyre, on each side
## The side of the tub behind the bonnet, from the floor upwards; the openings over the wheels come on top.
const TUB: Array[Vector2] = [
	Vector2(0.66, 0.56),
	Vector2(0.66, 1.08),
	Vector2(0.5, 1.12),
	Vector2(0.38, 1.08),
	Vector2(0.3, 0.98),
	Vector2(0.27, 0.8),
	Vector2(0.2, 0.74),
	Vector2(-0.36, 0.74),
	Vector2(-0.46, 0.8),
	Vector2(-0.5, 1.0),
	Vector2(-0.58, 1.07),
	Vector2(REAR, 1.07),
	Vector2(REAR, 0.62)
]
const FENDER: Array[Vector2] = [
	Vector2(0.64, 0.62),
	Vector2(0.68, 0.86),
	Vector2(0.78, 0.99),
	Vector2(0.95, 1.03),
	Vector2(1.5, 1.03),
	Vector2(1.68, 1.0),
	Vector2(1.78, 0.9),
	Vector2(1.8, 0.78)
]


static func body() -> ArrayMesh:
	var mould := Mould.new()
	mould.dirt = DIRT
	_add_frame(mould)
	_add_tub(mould)
	_add_front(mould)
	_add_seats(mould)
	_add_bars(mould)
	_add_fittings(mould)
	return mould.commit()


## Rails, axles, springs and exhaust: what is seen below the body.
static func _add_frame(mould: Mould) -> void:
	mould.paint(BLACK, 0.8)
	for side: float in [-1.0, 1.0]:
		mould.box(Vector3(0.08, 0.12, 3.5), Mould.at(Vector3(0.42 * side, 0.53, 0.0)))
		mould.tube([Vector3(0.3 * side, 0.36, 0.0), Vector3(0.5 * side, 0.47, 0.15)], 0.02)
		mould.box(Vector3(0.18, 0.03, 1.0), Mould.at(Vector3(0.82 * side, 0.52, 0.0)), 0.01)  # a step
		for z: float in [-0.4, 0.4]:
			mould.box(Vector3(0.4, 0.03, 0.04), Mould.at(Vector3(0.6 * side, 0.52, z)))
		for axle: float in [-1.0, 1.0]:
			for leaf in 3:
				var half := 0.42 - 0.1 * leaf
				var z := AXLE.x * axle
				mould.sheet(
					[Vector2(z - half, 0.47), Vector2(z, 0.41 - 0.02 * leaf), Vector2(z + half, 0.47)], 0.4 * side, 0.46 * side, 0.012
				)
	for axle: float in [-1.0, 1.0]:
		mould.tube([Vector3(-0.7, 0.36, AXLE.x * axle), Vector3(0.7, 0.36, AXLE.x * axle)], 0.045)
		mould.lathe(
			[Vector2(0, -0.13), Vector2(0.1, -0.09), Vector2(0.13, 0.0), Vector2(0.1, 0.09), Vector2(0, 0.13)],
			Mould.at(Vector3(0.1, 0.37, AXLE.x * axle), Vector3(0.5 * PI, 0, 0))
		)
	mould.box(Vector3(1.3, 0.05, 2.3), Mould.at(Vector3(0.0, 0.62, -0.62)))
	mould.box(Vector3(0.5, 0.26, 0.5), Mould.at(Vector3(0.0, 0.46, 0.3)), 0.06)
	mould.paint(RUST, 0.9, 0.3)
	mould.tube([Vector3(-0.25, 0.42, 0.3), Vector3(-0.3, 0.42, -0.9), Vector3(-0.55, 0.46, -1.4), Vector3(-0.58, 0.46, -1.84)], 0.028)
	mould.lathe(
		[Vector2(0, 0), Vector2(0.08, 0.02), Vector2(0.08, 0.48), Vector2(0, 0.5)],
		Mould.at(Vector3(-0.29, 0.42, -0.85), Vector3(0.5 * PI, 0, 0))
	)


static func _add_tub(mould: Mould) -> void:
	mould.paint(GREEN, 0.45)
	var outline := PackedVector2Array(TUB)
	for i in 9:  # the opening over the wheel behind
		outline.append(Vector2(-AXLE.x, AXLE.y) + ARCH * Vector2.from_angle(lerpf(0.885 * PI, 0.09 * PI, i / 8.0)))
	for side: float in [-1.0, 1.0]:
		mould.plate(outline, (WIDE - 0.03) * side, WIDE * side)
		var arch := PackedVector2Array()
		for i in 9:
			arch.append(Vector2(-AXLE.x, AXLE.y) + (ARCH + 0.02) * Vector2.from_angle(lerpf(0.06 * PI, 0.9 * PI, i / 8.0)))
		arch.reverse()
		mould.sheet(arch, minf(0.5 * side, 0.9 * side), maxf(0.5 * side, 0.9 * side), 0.025)
		mould.sheet([Vector2(REAR, 1.1), Vector2(-0.6, 1.1), Vector2(-0.5, 1.06)], (WIDE - 0.06) * side, (WIDE + 0.03) * side, 0.03)
		mould.box(Vector3(0.36, 0.36, 0.03), Mould.at(Vector3(0.55 * side, 0.82, -0.62)))
	mould.box(Vector3(2.0 * WIDE, 0.46, 0.04), Mould.at(Vector3(0.0, 0.85, REAR)))
	mould.box(Vector3(1.0, 0.36, 0.02), Mould.at(Vector3(0.0, 0.85, REAR - 0.022)), 0.008)
	mould.box(Vector3(1.38, 0.34, 0.05), Mould.at(Vector3(0.0, 0.93, 0.52)))
	mould.paint(BLACK, 0.7)
	mould.box(Vector3(1.3, 0.12, 0.16), Mould.at(Vector3(0.0, 1.03, 0.44)), 0.04)
	for x: float in [0.2, 0.36, 0.52]:
		mould.disc(0.045, 0.02, Mould.at(Vector3(x, 1.03, 0.355), Vector3(0.5 * PI, 0, 0)))


static func _add_front(mould: Mould) -> void:
	mould.paint(GREEN, 0.4)
	mould.box(Vector3(1.14, 0.46, 1.1), Mould.at(Vector3(0.0, 0.82, 1.15)), 0.02)
	mould.box(Vector3(1.18, 0.09, 1.14), Mould.at(Vector3(0.0, 1.09, 1.14), Vector3(0.03, 0, 0)), 0.04, Vector2(0.94, 0.98))
	mould.box(Vector3(0.46, 0.04, 0.94), Mould.at(Vector3(0.0, 1.145, 1.1), Vector3(0.03, 0, 0)), 0.018, Vector2(0.86, 0.94))
	mould.box(Vector3(1.2, 0.5, 0.06), Mould.at(Vector3(0.0, 0.84, 1.72)), 0.025)
	for side: float in [-1.0, 1.0]:
		mould.sheet(FENDER, minf(0.56 * side, 0.95 * side), maxf(0.56 * side, 0.95 * side), 0.025)
	mould.paint(BLACK, 0.95)
	for i in 7:
		mould.box(Vector3(0.045, 0.28, 0.03), Mould.at(Vector3(0.085 * (i - 3), 0.86, 1.745)), 0.02)
	for side: float in [-1.0, 1.0]:
		mould.paint(BLACK, 0.6)
		_add_lamp(mould, Vector3(0.44 * side, 0.9, 1.75), 0.115, Color(0.5, 0.53, 0.55))
		_add_lamp(mould, Vector3(0.75 * side, 0.93, 1.77), 0.045, Color(0.85, 0.45, 0.1))
		mould.box(Vector3(0.03, 0.12, 0.04), Mould.at(Vector3(0.585 * side, 1.02, 1.2)), 0.008)  # a catch of the bonnet


static func _add_lamp(mould: Mould, at: Vector3, radius: float, color: Color) -> void:
	var ahead := Mould.at(at, Vector3(0.5 * PI, 0, 0))
	mould.paint(STEEL, 0.3, 0.8)
	mould.lathe([Vector2(1.15 * radius, -0.02), Vector2(1.15 * radius, 0.02), Vector2(radius, 0.035), Vector2(radius, 0.02)], ahead)
	mould.paint(color, 0.1)
	mould.lathe([Vector2(radius, 0.015), Vector2(0.7 * radius, 0.035), Vector2(0.35 * radius, 0.045), Vector2(0, 0.048)], ahead)


static func _add_seats(mould: Mould) -> void:
	for side: float in [-1.0, 1.0]:
		mould.paint(LEATHER, 0.65)
		for half: float in [-1.0, 1.0]:  # two cushions with a seam
			var x := 0.34 * side + 0.12 * half
			mould.box(Vector3(0.235, 0.15, 0.48), Mould.at(Vector3(x, 0.83, -0.22), Vector3(-0.08, 0, 0)), 0.05)
			mould.box(Vector3(0.235, 0.56, 0.13), Mould.at(Vector3(x, 1.12, -0.5), Vector3(-0.16, 0, 0)), 0.05, Vector2(0.95, 0.8))
		mould.box(Vector3(0.27, 0.17, 0.1), Mould.at(Vector3(0.34 * side, 1.49, -0.58), Vector3(-0.16, 0, 0)), 0.045)
		mould.paint(BLACK, 0.7)
		mould.box(Vector3(0.4, 0.14, 0.4), Mould.at(Vector3(0.34 * side, 0.7, -0.22)))
	mould.tube([Vector3(0.0, 0.65, 0.12), Vector3(0.0, 0.95, 0.02)], 0.012)
	mould.lathe([Vector2(0, -0.03), Vector2(0.03, 0.0), Vector2(0, 0.03)], Mould.at(Vector3(0.0, 0.97, 0.02)))
	mould.tube([Vector3(0.36, 0.98, 0.42), Vector3(0.36, 1.17, 0.13)], 0.022)
	var rim := PackedVector3Array()
	var turned := Basis.from_euler(Vector3(-0.98, 0, 0))
	for i in 21:
		rim.append(Vector3(0.36, 1.17, 0.13) + turned * Vector3(0.19 * sin(TAU * i / 20), 0.0, 0.19 * cos(TAU * i / 20)))
	mould.tube(rim, 0.014)
	for i in 3:
		mould.tube([Vector3(0.36, 1.17, 0.13), rim[[0, 7, 13][i]]], 0.01)


static func _add_bars(mould: Mould) -> void:
	mould.paint(GREEN, 0.45)
	mould.tube([Vector3(-0.69, 1.1, 0.52), Vector3(-0.66, 1.56, 0.42), Vector3(0.66, 1.56, 0.42), Vector3(0.69, 1.1, 0.52)], 0.026)
	mould.box(Vector3(1.36, 0.05, 0.05), Mould.at(Vector3(0.0, 1.13, 0.52)), 0.015)
	mould.paint(BLACK, 0.55)
	mould.tube(
		[
			Vector3(-0.65, 0.66, -0.75),
			Vector3(-0.65, 1.68, -0.75),
			Vector3(-0.55, 1.78, -0.75),
			Vector3(0.55, 1.78, -0.75),
			Vector3(0.65, 1.68, -0.75),
			Vector3(0.65, 0.66, -0.75)
		],
		0.032
	)
	for side: float in [-1.0, 1.0]:
		mould.tube([Vector3(0.62 * side, 1.72, -0.75), Vector3(0.64 * side, 1.08, -1.66)], 0.028)
		mould.tube([Vector3(0.62 * side, 1.72, -0.75), Vector3(0.66 * side, 1.56, 0.42)], 0.022)
	mould.tube([Vector3(-0.4, 1.13, 0.56), Vector3(-0.1, 1.3, 0.5)], 0.008)  # wipers
	mould.tube([Vector3(0.15, 1.13, 0.56), Vector3(0.45, 1.3, 0.5)], 0.008)


static func _add_fittings(mould: Mould) -> void:
	mould.paint(BLACK, 0.7)
	mould.box(Vector3(1.66, 0.15, 0.1), Mould.at(Vector3(0.0, 0.6, 1.84)), 0.03)
	for side: float in [-1.0, 1.0]:
		mould.paint(BLACK, 0.7)
		mould.box(Vector3(0.4, 0.13, 0.1), Mould.at(Vector3(0.6 * side, 0.58, REAR - 0.06)), 0.03)
		mould.box(Vector3(0.15, 0.2, 0.04), Mould.at(Vector3(0.64 * side, 0.92, REAR - 0.03)), 0.012)
		mould.tube([Vector3(0.7 * side, 1.2, 0.5), Vector3(0.86 * side, 1.24, 0.52)], 0.01)
		mould.box(Vector3(0.17, 0.12, 0.04), Mould.at(Vector3(0.9 * side, 1.27, 0.52)), 0.018)
		mould.tube([Vector3(0.5 * side, 0.56, 1.9), Vector3(0.5 * side, 0.56, 1.95), Vector3(0.44 * side, 0.56, 1.95)], 0.016)
		mould.paint(Color(0.55, 0.06, 0.05), 0.15)
		mould.box(Vector3(0.12, 0.09, 0.03), Mould.at(Vector3(0.64 * side, 0.96, REAR - 0.05)), 0.012)
		mould.paint(Color(0.8, 0.42, 0.1), 0.15)
		mould.box(Vector3(0.12, 0.055, 0.03), Mould.at(Vector3(0.64 * side, 0.87, REAR - 0.05)), 0.012)
	mould.paint(CREAM, 0.5)
	mould.box(Vector3(0.4, 0.11, 0.01), Mould.at(Vector3(-0.1, 0.6, 1.895)), 0.004)
	mould.box(Vector3(0.3, 0.11, 0.012), Mould.at(Vector3(-0.44, 0.72, REAR - 0.03)), 0.004)
	mould.paint(Color(0.36, 0.36, 0.24), 0.6)  # a can on its carrier, beside the spare wheel
	mould.box(Vector3(0.3, 0.4, 0.15), Mould.at(Vector3(-0.5, 1.06, REAR - 0.1)), 0.04)
	mould.tube(
		[
			Vector3(-0.6, 1.27, REAR - 0.1),
			Vector3(-0.57, 1.31, REAR - 0.1),
			Vector3(-0.43, 1.31, REAR - 0.1),
			Vector3(-0.4, 1.27, REAR - 0.1)
		],
		0.012
	)


## A wheel, whose axle is along x, with its outer side at +x.
static func wheel(radius: float) -> ArrayMesh:
	var mould := Mould.new()
	mould.dirt = Vector2(-1.6 * radius, 2.6 * radius)  # some everywhere: it turns
	var along_x := Mould.at(Vector3.ZERO, Vector3(0, 0, -0.5 * PI))
	mould.paint(RUBBER, 0.85)
	var tread := radius - 0.018
	mould.lathe(
		[
			Vector2(0.23, -0.085),
			Vector2(0.27, -0.115),
			Vector2(0.33, -0.125),
			Vector2(tread - 0.02, -0.115),
			Vector2(tread, -0.085),
			Vector2(tread, 0.085),
			Vector2(tread - 0.02, 0.115),
			Vector2(0.33, 0.125),
			Vector2(0.27, 0.115),
			Vector2(0.23, 0.085)
		],
		along_x,
		40
	)
	for i in LUGS:
		for side: float in [-1.0, 1.0]:
			var turned := Basis(Vector3.RIGHT, TAU * (i + 0.25 * side) / LUGS)
			var lug := Transform3D(turned * Basis(Vector3.UP, 0.45 * side), turned * Vector3(0.062 * side, tread, 0.0))
			mould.box(Vector3(0.1, 0.04, 0.042), lug, 0.008, Vector2(0.9, 0.8))
	mould.paint(CREAM, 0.4, 0.0)
	mould.lathe([Vector2(0.205, -0.08), Vector2(0.235, -0.09), Vector2(0.235, -0.1)], along_x, 32)
	mould.lathe(
		[
			Vector2(0.235, 0.085),
			Vector2(0.24, 0.1),
			Vector2(0.225, 0.1),
			Vector2(0.2, 0.07),
			Vector2(0.195, 0.0),
			Vector2(0.17, -0.005),
			Vector2(0.13, 0.035),
			Vector2(0.09, 0.045),
			Vector2(0.0, 0.045)
		],
		along_x,
		32
	)
	mould.paint(BLACK, 0.8)
	mould.lathe([Vector2(0.0, -0.06), Vector2(0.205, -0.06)], along_x, 32)
	for i in 8:
		var way := Vector3(0.0, cos(TAU * i / 8), sin(TAU * i / 8))
		mould.disc(0.02, 0.012, Mould.at(0.155 * way + 0.016 * Vector3.RIGHT, Vector3(0, 0, -0.5 * PI + 0.0)))
	mould.paint(STEEL, 0.45, 0.7)
	mould.lathe([Vector2(0.06, 0.04), Vector2(0.06, 0.08), Vector2(0.045, 0.1), Vector2(0.0, 0.105)], along_x)
	for i in 5:
		mould.disc(
			0.014, 0.03, Mould.at(Vector3(0.055, 0.095 * cos(TAU * i / 5), 0.095 * sin(TAU * i / 5)), Vector3(0, 0, 0.5 * PI)), 0.004
		)
	return mould.commit()
