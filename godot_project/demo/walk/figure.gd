# SPDX-License-Identifier: MIT
## How somebody on foot looks: a hat, a shirt, and limbs that swing with the steps. The physics knows a capsule only.
extends Node3D

const Look := preload("res://demo/walk/look.gd")
const Mould := preload("res://demo/walk/mould.gd")
const STRIDE := 0.75  # metres from one foot to the other
const SWING := 0.55  # radians, of a leg at full pace
const FULL_PACE := 2.2  # m/s
const SHIRT := Color(0.5, 0.2, 0.15)
const TROUSERS := Color(0.22, 0.25, 0.33)
const BOOTS := Color(0.24, 0.17, 0.12)
const SKIN := Color(0.72, 0.52, 0.4)
const HAIR := Color(0.25, 0.17, 0.11)
const STRAW := Color(0.74, 0.62, 0.38)
const BAND := Color(0.3, 0.2, 0.14)
const FLAT := Vector3(1.0, 1.0, 0.62)  # depth of a trunk beside its width

var holds := false  ## something in front, with both hands

var _legs: Array[Node3D] = []
var _arms: Array[Node3D] = []
var _walked := 0.0  # metres


func _ready() -> void:
	Look.add_mesh(self, _trunk(), Vector3.ZERO)
	for side: float in [-1.0, 1.0]:
		_legs.append(Look.add_mesh(self, _leg(), Vector3(0.095 * side, 0.9, 0.0)))
		_arms.append(Look.add_mesh(self, _arm(), Vector3(0.2 * side, 1.395, 0.0)))
		_arms[-1].rotation.z = 0.1 * side


## Moves the limbs after a way of `by` metres at `pace` m/s.
func step(by: float, pace: float) -> void:
	_walked += by
	var swing := SWING * minf(pace / FULL_PACE, 1.0) * sin(PI * _walked / STRIDE)
	for i in 2:
		var side := 1.0 if i else -1.0
		_legs[i].rotation.x = swing * side
		_arms[i].rotation.x = 0.6 if holds else -0.7 * swing * side


## The trunk, the head and the hat.
static func _trunk() -> ArrayMesh:
	var mould := Mould.new()
	var flat := Transform3D(Basis.from_scale(FLAT), Vector3.ZERO)
	mould.paint(TROUSERS, 0.9)
	mould.lathe([Vector2(0.0, 0.8), Vector2(0.13, 0.82), Vector2(0.175, 0.9), Vector2(0.165, 1.0)], flat)
	mould.paint(BOOTS, 0.6)
	mould.lathe([Vector2(0.172, 0.98), Vector2(0.17, 1.02)], flat)
	mould.paint(SHIRT, 0.95)
	mould.lathe(
		[
			Vector2(0.168, 1.01),
			Vector2(0.165, 1.08),
			Vector2(0.185, 1.25),
			Vector2(0.2, 1.36),
			Vector2(0.19, 1.42),
			Vector2(0.13, 1.475),
			Vector2(0.075, 1.5)
		],
		flat
	)
	mould.lathe([Vector2(0.085, 1.48), Vector2(0.08, 1.52), Vector2(0.06, 1.5)], Mould.at(Vector3.ZERO))
	mould.paint(SKIN, 0.7)
	mould.lathe([Vector2(0.058, 1.45), Vector2(0.056, 1.56)], Mould.at(Vector3.ZERO))
	var head := Transform3D(Basis.from_scale(Vector3(0.86, 1.0, 1.0)), Vector3(0.0, 0.0, -0.015))
	mould.lathe(
		[Vector2(0.0, 1.52), Vector2(0.055, 1.535), Vector2(0.09, 1.59), Vector2(0.1, 1.65), Vector2(0.098, 1.7), Vector2(0.0, 1.74)], head
	)
	mould.box(Vector3(0.025, 0.045, 0.04), Mould.at(Vector3(0.0, 1.625, -0.115)), 0.01)
	for side: float in [-1.0, 1.0]:
		mould.box(Vector3(0.02, 0.05, 0.03), Mould.at(Vector3(0.09 * side, 1.63, -0.01)), 0.008)
	mould.paint(HAIR, 0.9)
	mould.lathe([Vector2(0.085, 1.58), Vector2(0.105, 1.62), Vector2(0.106, 1.7)], Transform3D(head.basis, Vector3(0.0, 0.0, 0.004)))
	var hat := Mould.at(Vector3(0.0, 1.685, -0.01), Vector3(-0.07, 0.0, 0.0))
	mould.paint(STRAW, 0.95)
	mould.lathe(
		[
			Vector2(0.1, 0.0),
			Vector2(0.17, -0.012),
			Vector2(0.235, 0.012),
			Vector2(0.24, 0.02),
			Vector2(0.17, 0.0),
			Vector2(0.122, 0.01),
			Vector2(0.116, 0.07),
			Vector2(0.1, 0.105),
			Vector2(0.055, 0.118),
			Vector2(0.0, 0.105)
		],
		hat
	)
	mould.paint(BAND, 0.8)
	mould.lathe([Vector2(0.124, 0.01), Vector2(0.12, 0.042)], hat)
	return mould.commit()


## A leg below its joint, with a boot that points ahead.
static func _leg() -> ArrayMesh:
	var mould := Mould.new()
	mould.dirt = Vector2(-1.0, -0.55)
	mould.paint(TROUSERS, 0.9)
	mould.lathe(
		[
			Vector2(0.07, -0.82),
			Vector2(0.075, -0.7),
			Vector2(0.07, -0.62),
			Vector2(0.075, -0.48),
			Vector2(0.092, -0.25),
			Vector2(0.1, -0.05),
			Vector2(0.08, 0.04),
			Vector2(0.0, 0.07)
		],
		Mould.at(Vector3.ZERO)
	)
	mould.paint(BOOTS, 0.65)
	mould.lathe([Vector2(0.055, -0.86), Vector2(0.062, -0.76), Vector2(0.066, -0.7)], Mould.at(Vector3.ZERO))
	mould.box(Vector3(0.1, 0.09, 0.27), Mould.at(Vector3(0.0, -0.84, -0.06)), 0.035, Vector2(0.8, 0.75))
	return mould.commit()


static func _arm() -> ArrayMesh:
	var mould := Mould.new()
	var bent := Mould.at(Vector3(0.0, -0.28, 0.0), Vector3(0.25, 0.0, 0.0))
	mould.paint(SHIRT, 0.95)
	mould.lathe(
		[Vector2(0.05, -0.3), Vector2(0.055, -0.2), Vector2(0.063, -0.05), Vector2(0.06, 0.02), Vector2(0.04, 0.045), Vector2(0.0, 0.055)],
		Mould.at(Vector3.ZERO)
	)
	mould.lathe([Vector2(0.056, -0.08), Vector2(0.054, -0.03), Vector2(0.04, 0.02), Vector2(0.0, 0.03)], bent)
	mould.paint(SKIN, 0.7)
	mould.lathe([Vector2(0.028, -0.25), Vector2(0.04, -0.1), Vector2(0.044, -0.05)], bent)
	mould.box(Vector3(0.035, 0.13, 0.08), bent * Mould.at(Vector3(0.0, -0.3, 0.0)), 0.017, Vector2(0.9, 0.7))
	return mould.commit()
