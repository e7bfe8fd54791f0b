# SPDX-License-Identifier: MIT
## The features that are shown before and after.
extends RefCounted

const Pair := preload("res://demo/pairs/pair.gd")
const ALL := {
	bent = Bent,
	risen = Risen,
	wind = Wind,
	blast = Flattened,
	mown = Mown,
	worn = Worn,
	painted = Painted,
	species = Species,
	density = Density,
	snow = Snow,
	wet = Wet,
}


## A ball that rolls.
class Rolled:
	extends Pair
	const Look := preload("res://demo/walk/look.gd")
	const BodyLook := preload("res://demo/body_look.gd")
	const RADIUS := 0.45  # metres
	var pace := 6.0  # m/s
	var _ball: AnimatableBody3D

	## Rolls it from one place to another, along z.
	func roll(from: float, to: float) -> void:
		_ball = AnimatableBody3D.new()
		var shape := SphereShape3D.new()
		shape.radius = RADIUS
		Look.add_shape(_ball, shape)
		Look.add_mesh(_ball, BodyLook.mesh(BodyLook.Kind.BALL, 0), Vector3.ZERO).scale = Vector3.ONE * RADIUS / BodyLook.BALL
		_ball.sync_to_physics = false
		add_child(_ball)
		var along := from
		while along != to:
			_ball.global_position = on_ground(Vector3(0.0, RADIUS, along))
			along = move_toward(along, to, pace / Engine.physics_ticks_per_second)
			await get_tree().physics_frame


class Bent:
	extends Rolled

	func _init() -> void:
		about = "Grass at rest; a ball rolls through it"
		settles = 0.05

	func make(is_after: bool) -> void:
		if is_after:
			await roll(4.0, -0.6)


class Risen:
	extends Rolled
	const RISES := 2.0  # seconds

	func _init() -> void:
		about = "A ball has just passed; two seconds later"
		pace = 12.0
		settles = 0.05

	func make(is_after: bool) -> void:
		await roll(-4.0, 3.0)
		_ball.queue_free()
		if is_after:
			await wait(RISES)


class Wind:
	extends Pair

	func _init() -> void:
		about = "A calm; a gust"
		eye = Vector3(0.2, 1.2, 3.6)

	func make(is_after: bool) -> void:
		stage.set_wind(12.0 if is_after else 0.0, 1.0)
		await wait(1.0)


class Flattened:
	extends Pair

	func _init() -> void:
		about = "Before a blast; a third of a second after it"
		eye = Vector3(0.2, 2.6, 5.4)

	func make(is_after: bool) -> void:
		if is_after:
			stage.country.field.blast(on_ground(Vector3(0.0, 0.3, 0.0)), 45.0, 6.0)


class Mown:
	extends Pair
	const Mower := preload("res://demo/walk/mower.gd")

	func _init() -> void:
		about = "Grown; a swath is mown"

	func make(is_after: bool) -> void:
		if not is_after:
			return
		var mower := Mower.new()
		add_child(mower)
		for i in 150:
			mower.push(on_ground(Vector3(0.0, 0.0, 3.2 - 0.03 * i)), 0.0, stage.hills, stage.country)
			await get_tree().physics_frame


class Worn:
	extends Pair

	func _init() -> void:
		about = "Untrodden; a path, trodden by many feet"

	func make(is_after: bool) -> void:
		if is_after:
			for i in 60:
				stage.country.field.trample(on_ground(Vector3(0.35 * sin(0.25 * i), 0.0, 4.0 - 0.2 * i)), 0.42, 0.9)


class Painted:
	extends Pair
	var _own: GrassMap

	func _init() -> void:
		about = "Unpainted; with a path and a low verge, by two brushes"
		middle = Vector3(8.0, 0.0, -10.0)
		eye = Vector3(0.2, 2.0, 4.2)

	func make(is_after: bool) -> void:
		_own = stage.country.field.map
		if not is_after:
			return
		stage.country.field.map = _own.duplicate()
		var verge := GrassBrush.new()
		verge.tool = GrassBrush.TOOL_HEIGHT
		verge.target = 0.4
		verge.strength = 1.0
		verge.radius = 1.4
		var path := GrassBrush.new()
		path.tool = GrassBrush.TOOL_ERASE
		path.strength = 1.0
		path.radius = 0.55
		for brush: GrassBrush in [verge, path]:
			for i in 16:
				stage.country.field.paint(brush, _along(i), _along(i + 1))

	func undo() -> void:
		stage.country.field.map = _own

	func _along(i: int) -> Vector3:
		return on_ground(Vector3(0.7 * sin(0.45 * i), 0.0, 4.5 - i))


## Changes a property of the field in the middle, and changes it back.
class Changed:
	extends Pair
	var property := &""
	var before: Variant
	var _own: Variant

	func make(is_after: bool) -> void:
		_own = stage.country.field.get(property)
		rebuilds = true
		if not is_after:
			stage.country.field.set(property, before)

	func undo() -> void:
		stage.country.field.set(property, _own)


class Species:
	extends Changed

	func _init() -> void:
		about = "One species; five"
		property = &"species"
		var meadow: Array[GrassSpecies] = [load("res://addons/grass_field/presets/meadow.tres")]
		before = meadow


class Density:
	extends Changed

	func _init() -> void:
		about = "40 blades a square metre; 256"
		property = &"density"
		before = 40.0


## What the weather leaves on grass and soil.
class Weather:
	extends Pair
	var snow := 0.0
	var wetness := 0.0

	func make(is_after: bool) -> void:
		if is_after:
			_cover(snow, wetness)

	func undo() -> void:
		_cover(0.0, 0.0)

	func _cover(p_snow: float, p_wetness: float) -> void:
		stage.hills.cover(p_snow, p_wetness)
		for field: GrassField in stage.country.fields:
			field.snow = p_snow
			field.wetness = p_wetness


class Snow:
	extends Weather

	func _init() -> void:
		about = "Summer; snow"
		snow = 0.8


class Wet:
	extends Weather

	func _init() -> void:
		about = "Dry; after rain"
		wetness = 1.0
