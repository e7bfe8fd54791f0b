# SPDX-License-Identifier: MIT
## The objects in the tiles of bench_kernel.gd, as records of colliders.
##   0, 4: so many balls that move through each tile;  lid: a wide flat box that rises and falls in the tips;
##   bodies: one of a ball, crate, capsule, drum and stone lies in every 25 tiles;  rolling: the same, turning to and fro.

const ALL: Array[String] = ["0", "4", "lid", "bodies", "rolling"]
const HULL_PLANES := 22
const BODY := 0.42  # metres
const GROUP := 5  # tiles along the square of a body
enum { SPHERE, CAPSULE, BOX, CYLINDER, HULL }


## In one of the 8 phases of the way to and fro, p_colliders of each tile. Tiles lie in rows of p_across.
static func colliders(p_scene: String, p_tiles: int, p_across: int, p_colliders: int, p_phase: int) -> PackedByteArray:
	var all := PackedByteArray()
	for tile in p_tiles:
		var at := Vector2i(tile % p_across, tile / p_across)
		for entry in p_colliders:
			var record := _lid(p_phase) if p_scene == "lid" else _ball(entry, p_phase)
			if p_scene in ["bodies", "rolling"]:
				at = at / GROUP * GROUP + Vector2i.ONE * (GROUP / 2)
				record = _body((at.x + 3 * at.y) / GROUP % 5, p_phase, p_scene == "rolling")
			record.encode_s32(0, at.x)
			record.encode_s32(4, at.y)
			all.append_array(record)
	if all.is_empty():
		all.resize(96)
	return all


static func _record(
	p_shape: int, p_size: Vector3, p_now: Vector3, p_before: Vector3, p_turn := Quaternion.IDENTITY, p_turn_before := Quaternion.IDENTITY
) -> PackedByteArray:
	var record := (
		PackedFloat32Array(
			[
				0,
				0,
				0,
				0,
				p_now.x,
				p_now.y,
				p_now.z,
				0.5,
				p_turn.x,
				p_turn.y,
				p_turn.z,
				p_turn.w,
				p_before.x,
				p_before.y,
				p_before.z,
				HULL_PLANES if p_shape == HULL else 0,
				p_turn_before.x,
				p_turn_before.y,
				p_turn_before.z,
				p_turn_before.w,
				p_size.x,
				p_size.y,
				p_size.z,
				0
			]
		)
		. to_byte_array()
	)
	record.encode_s32(8, p_shape)
	return record


## Balls of 8 cm, one in each quarter of the tile, that move to and fro by 1 cm a step.
static func _ball(p_entry: int, p_phase: int) -> PackedByteArray:
	var place := Vector3(0.125 if p_entry & 1 else -0.125, 0.2, 0.125 if p_entry & 2 else -0.125)
	return _record(
		SPHERE,
		Vector3(0.08, 0, 0),
		place + Vector3(0.01 * absi(p_phase - 4), 0, 0),
		place + Vector3(0.01 * absi((p_phase + 7) % 8 - 4), 0, 0)
	)


## 32 metres wide, by 0.4 mm a step.
static func _lid(p_phase: int) -> PackedByteArray:
	return _record(
		BOX,
		Vector3(16, 0.1, 16),
		Vector3(0, 0.45 + 0.0004 * absi(p_phase - 4), 0),
		Vector3(0, 0.45 + 0.0004 * absi((p_phase + 7) % 8 - 4), 0)
	)


## On the ground; rolling by 1 cm a step, a stone at 25 mrad.
static func _body(p_shape: int, p_phase: int, p_moves: bool) -> PackedByteArray:
	var size := BODY * Vector3(0.5, 0.3, 0.4)
	var height := size.y
	var turn := Quaternion(Vector3.UP, 0.7)
	match p_shape:
		SPHERE:
			height = size.x
		CAPSULE:
			size = BODY * Vector3(0.3, 0.5, 0)
			height = size.x
			turn = Quaternion(Vector3(1, 0, 0.3).normalized(), 0.5 * PI)
		CYLINDER:
			size = BODY * Vector3(0.45, 0.35, 0)
			height = size.y
		HULL:
			size = BODY * Vector3(0.65, 0, 0)
			height = 0.45 * BODY
	var places: Array[Vector3] = []
	var turns: Array[Quaternion] = []
	for phase: int in [p_phase, (p_phase + 7) % 8] if p_moves else [4, 4]:
		places.append(Vector3(0.01 * absi(phase - 4), height, 0))
		turns.append(Quaternion(Vector3.BACK, 0.025 * absi(phase - 4)) * turn)
	return _record(p_shape, size, places[0], places[1], turns[0], turns[1])


## Returns the planes of a stone.
static func stone() -> PackedByteArray:
	var planes := PackedFloat32Array()
	for i in HULL_PLANES:
		var y := 1.0 - (2.0 * i + 1.0) / HULL_PLANES
		var across := sqrt(1.0 - y * y)
		planes.append_array([across * cos(2.4 * i), y, across * sin(2.4 * i), BODY * (0.42 + 0.06 * fmod(0.618 * i, 1.0))])
	return planes.to_byte_array()
