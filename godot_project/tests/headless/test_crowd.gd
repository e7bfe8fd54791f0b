# SPDX-License-Identifier: MIT
## A crowd on more tiles than the pool holds: the tiles that the camera sees get the slots.
extends "res://tests/field_case.gd"

const SIDE := 20  # bodies along a side of the crowd
const APART := 2.0  # metres
const RADIUS := 0.15  # metres
const POOL := 1024  # tiles; the crowd touches several times as many
const EYE := Vector3(0, 2, 0)  # amid the crowd
const TURNING := 40  # ticks in which all slots may have gone where a camera has turned to


func add_crowd() -> Array[AnimatableBody3D]:
	var crowd: Array[AnimatableBody3D] = []
	for x in SIDE:
		for z in SIDE:
			var place := Vector3(APART * (x - 0.5 * (SIDE - 1)), RADIUS, APART * (z - 0.5 * (SIDE - 1)))
			crowd.append(add_held_body(ball(RADIUS), place))
	return crowd


func add_camera() -> Camera3D:
	var camera := Camera3D.new()
	camera.position = EYE
	camera.fov = 25.0
	camera.current = true
	add_child(camera)
	return camera


## Turns the camera and lets the field know, as a frame that is drawn does.
func turn(camera: Camera3D, degrees: float) -> void:
	camera.rotation_degrees = Vector3(-10, degrees, 0)
	RenderingServer.frame_pre_draw.emit()


## Returns tiles that a body of the crowd touches and whose middle the camera sees.
func tiles_in_sight(field: GrassField, camera: Camera3D, crowd: Array[AnimatableBody3D]) -> Array[Vector2i]:
	var tiles: Array[Vector2i] = []
	for body in crowd:
		for to: Vector3 in [Vector3.ZERO, Vector3.LEFT, Vector3.RIGHT, Vector3.FORWARD, Vector3.BACK]:
			var tile := field.get_tile_at(body.position + 0.5 * RADIUS * to)
			if camera.is_position_in_frustum(field.get_tile_center(tile)) and not tile in tiles:
				tiles.append(tile)
	return tiles


func asleep(field: GrassField, tiles: Array[Vector2i]) -> int:
	return tiles.filter(func(tile: Vector2i) -> bool: return not field.is_tile_awake(tile)).size()


func test_all_that_a_camera_sees_is_awake_wherever_it_turns() -> void:
	var field := add_field({size = Vector2(44, 44), pool_tiles = POOL})
	var camera := add_camera()
	var crowd := add_crowd()
	for degrees: float in [0.0, 90.0, 200.0]:
		turn(camera, degrees)
		await ticks(TURNING)
		var in_sight := tiles_in_sight(field, camera, crowd)
		assert_greater(in_sight.size(), 20, "the camera sees some of the crowd")
		assert_less(in_sight.size(), POOL, "and not more than the pool holds")
		assert_eq(asleep(field, in_sight), 0, "of %d tiles in sight, at %d degrees" % [in_sight.size(), degrees])
		assert_eq(field.get_awake_tile_count(), POOL, "slots that are left go to others")
		assert_greater(field.get_statistics().refused, 0, "the pool is too small")
	assert_greater(field.get_counters().evicted, 0)
	var still := field.get_counters()
	await ticks(60)
	assert_eq(field.get_counters().woken, still.woken, "nothing flickers while the camera stands")


func test_without_a_camera_slots_stay_where_they_are() -> void:
	var field := add_field({size = Vector2(44, 44), pool_tiles = POOL})
	add_crowd()
	await ticks(TURNING)
	assert_eq(field.get_awake_tile_count(), POOL)
	assert_eq(field.get_counters().evicted, 0)
