# SPDX-License-Identifier: MIT
## How the mower looks. It is pushed towards -z; lengths are metres, from the ground below the middle of its deck.
extends RefCounted

const Mould := preload("res://demo/walk/mould.gd")
const RED := Color(0.58, 0.13, 0.09)
const BLACK := Color(0.2, 0.2, 0.2)
const RUBBER := Color(0.2, 0.2, 0.195)
const STEEL := Color(0.58, 0.58, 0.56)
const CLOTH := Color(0.24, 0.27, 0.22)
const CREAM := Color(0.75, 0.72, 0.62)
const WHEEL := 0.13  # radius


## deck: its size; bottom: how high its lower edge is.
static func mesh(deck: Vector3, bottom: float) -> ArrayMesh:
	var mould := Mould.new()
	mould.dirt = Vector2(0.02, 0.34)
	_add_deck(mould, deck, bottom)
	_add_engine(mould, bottom + deck.y)
	for x: float in [-1.0, 1.0]:
		for z: float in [-0.85, 0.85]:
			_add_wheel(mould, Vector3(x * (0.5 * deck.x + 0.03), WHEEL, 0.5 * z * deck.z), x)
	_add_handle(mould)
	_add_bag(mould, deck)
	return mould.commit()


static func _add_deck(mould: Mould, deck: Vector3, bottom: float) -> void:
	mould.paint(RED, 0.42)
	var skirt := 0.6 * deck.y
	mould.box(Vector3(deck.x, skirt, deck.z), Mould.at(Vector3(0.0, bottom + 0.5 * skirt, 0.0)), 0.02, Vector2(0.98, 0.97))
	mould.box(Vector3(0.94 * deck.x, deck.y, 0.92 * deck.z), Mould.at(Vector3(0.0, bottom + 0.5 * deck.y, 0.0)), 0.05, Vector2(0.9, 0.86))
	mould.lathe(
		[Vector2(0.42, 0.0), Vector2(0.36, 0.03), Vector2(0.2, 0.045), Vector2(0.0, 0.045)],
		Transform3D(Basis.from_scale(Vector3(1, 1, 0.8)), Vector3(0.0, bottom + deck.y - 0.012, 0.0)),
		32
	)
	mould.paint(BLACK, 0.8)
	mould.box(Vector3(1.01 * deck.x, 0.025, 1.01 * deck.z), Mould.at(Vector3(0.0, bottom + 0.012, 0.0)), 0.01)
	mould.paint(CREAM, 0.5)
	mould.box(Vector3(0.3, 0.05, 0.012), Mould.at(Vector3(0.0, bottom + 0.05, 0.5 * deck.z - 0.006)), 0.004)


## A cylinder with cooling ribs, a fan's cover with its starter, a tank, an air filter and a silencer.
static func _add_engine(mould: Mould, height: float) -> void:
	mould.paint(BLACK, 0.55)
	mould.lathe(
		[Vector2(0.17, 0.0), Vector2(0.175, 0.14), Vector2(0.15, 0.18), Vector2(0.09, 0.195), Vector2(0.0, 0.195)],
		Mould.at(Vector3(0.0, height, 0.0)),
		28
	)
	mould.paint(STEEL, 0.4, 0.7)
	for i in 6:
		mould.box(Vector3(0.17, 0.012, 0.15), Mould.at(Vector3(0.0, height + 0.03 + 0.024 * i, -0.22)), 0.004)
	mould.box(Vector3(0.1, 0.15, 0.12), Mould.at(Vector3(0.0, height + 0.085, -0.21)))
	mould.tube([Vector3(0.0, height + 0.1, -0.27), Vector3(0.0, height + 0.12, -0.34)], 0.014)
	for i in 16:
		var way := Vector3(cos(TAU * i / 16), 0.0, sin(TAU * i / 16))
		mould.box(
			Vector3(0.05, 0.006, 0.012), Transform3D(Basis(Vector3.UP, -TAU * i / 16), 0.1 * way + Vector3.UP * (height + 0.194)), 0.003
		)
	mould.disc(0.045, 0.02, Mould.at(Vector3(0.0, height + 0.2, 0.0)))
	mould.paint(RED, 0.35)
	mould.box(Vector3(0.16, 0.13, 0.26), Mould.at(Vector3(0.22, height + 0.11, 0.02)), 0.05)
	mould.paint(BLACK, 0.5)
	mould.disc(0.035, 0.035, Mould.at(Vector3(0.22, height + 0.19, 0.06)))
	mould.box(Vector3(0.13, 0.1, 0.16), Mould.at(Vector3(-0.22, height + 0.1, 0.02)), 0.025)
	mould.paint(Color(0.35, 0.28, 0.23), 0.85, 0.4)
	mould.lathe(
		[Vector2(0.0, -0.09), Vector2(0.05, -0.08), Vector2(0.05, 0.08), Vector2(0.0, 0.09)],
		Mould.at(Vector3(-0.16, height + 0.06, -0.2), Vector3(0, 0, 0.5 * PI))
	)


## side: -1 on the left, 1 on the right.
static func _add_wheel(mould: Mould, at: Vector3, side: float) -> void:
	var axle := Mould.at(at, Vector3(0, 0, -0.5 * PI * side))
	mould.paint(RUBBER, 0.85)
	mould.lathe(
		[
			Vector2(0.085, -0.035),
			Vector2(0.12, -0.04),
			Vector2(WHEEL, -0.025),
			Vector2(WHEEL, 0.025),
			Vector2(0.12, 0.04),
			Vector2(0.085, 0.035)
		],
		axle,
		28
	)
	for i in 20:
		var turned := Basis(Vector3.RIGHT, TAU * i / 20)
		mould.box(Vector3(0.05, 0.012, 0.016), Transform3D(turned, at + turned * Vector3(0.0, WHEEL, 0.0)), 0.003)
	mould.paint(CREAM, 0.5)
	mould.lathe([Vector2(0.0, -0.02), Vector2(0.09, -0.025)], axle)
	mould.lathe(
		[Vector2(0.088, 0.03), Vector2(0.075, 0.035), Vector2(0.07, 0.01), Vector2(0.04, 0.01), Vector2(0.03, 0.035), Vector2(0.0, 0.038)],
		axle
	)
	mould.paint(STEEL, 0.4, 0.7)
	mould.disc(0.014, 0.03, Mould.at(at + Vector3(0.04 * side, 0, 0), Vector3(0, 0, 0.5 * PI)), 0.004)


static func _add_handle(mould: Mould) -> void:
	mould.paint(STEEL, 0.35, 0.75)
	mould.tube(
		[
			Vector3(-0.27, 0.2, 0.36),
			Vector3(-0.27, 0.62, 0.76),
			Vector3(-0.25, 1.0, 1.08),
			Vector3(0.25, 1.0, 1.08),
			Vector3(0.27, 0.62, 0.76),
			Vector3(0.27, 0.2, 0.36)
		],
		0.016
	)
	mould.tube([Vector3(-0.26, 0.78, 0.9), Vector3(0.26, 0.78, 0.9)], 0.01)
	mould.paint(BLACK, 0.85)
	mould.tube([Vector3(-0.19, 1.0, 1.08), Vector3(0.19, 1.0, 1.08)], 0.023)
	mould.tube([Vector3(-0.21, 1.0, 1.08), Vector3(-0.21, 1.04, 1.02), Vector3(0.21, 1.04, 1.02), Vector3(0.21, 1.0, 1.08)], 0.007)
	for x: float in [-0.27, 0.27]:
		mould.disc(0.03, 0.04, Mould.at(Vector3(x, 0.62, 0.76), Vector3(0, 0, 0.5 * PI)))
	mould.tube([Vector3(0.22, 1.01, 1.06), Vector3(0.275, 0.66, 0.8), Vector3(0.28, 0.3, 0.45), Vector3(0.12, 0.36, 0.1)], 0.006)


## What the cut grass flies into.
static func _add_bag(mould: Mould, deck: Vector3) -> void:
	mould.paint(CLOTH, 0.95)
	mould.box(Vector3(0.46, 0.28, 0.42), Mould.at(Vector3(0.0, 0.34, 0.5 * deck.z + 0.16), Vector3(0.12, 0, 0)), 0.09, Vector2(0.9, 0.82))
	mould.paint(BLACK, 0.7)
	mould.box(Vector3(0.48, 0.02, 0.4), Mould.at(Vector3(0.0, 0.35, 0.5 * deck.z + 0.16), Vector3(0.12, 0, 0)), 0.008)
