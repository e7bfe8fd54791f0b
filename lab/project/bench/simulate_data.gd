# SPDX-License-Identifier: MIT
## What simulate.glsl reads, for benchmarks: slot records, push constants and a patch, laid out as in shaders/base.
extends RefCounted

const FREQUENCY := 1.2  # Hz
const BLADES := 64  # a tile
const ROOM := 256  # tiles for which the buffer of joints has room, where there is one


## A slot record with a workgroup of its own: tile x, tile z, slot, first blade of the patch, first collider of the list, how many, bits.
static func slot_words(p_x: int, p_z: int, p_slot: int, p_blade: int, p_first: int, p_count: int, p_bits: int) -> PackedInt32Array:
	return [p_x, p_z, p_slot, p_slot, p_blade, p_first, p_count, p_bits, 0, 0, 0, 0, p_slot, BLADES, 1, p_slot % ROOM]


## Returns the push constant of a step at 60 Hz. p_load: m/s^2.
static func push(p_method: int, p_knots: int, p_tile_size: float, p_tiles: int, p_load: Vector3, p_iterations := 2) -> PackedByteArray:
	var w := TAU * FREQUENCY
	var h := 1.0 / 60.0
	var pull := w * w * h * h
	var load := p_load if p_method == 0 else p_load * h * h
	var bending := pow(w / 3.516, 2.0)
	var pbd_motion: Array[float] = [1.0, 0.5, 0.0, 0.0]
	if p_method != 0:
		pbd_motion = [0.9, pull, pull, 0.5]
	var free_motion: Array[float] = [h * tan(0.5 * w * h) / (0.5 * w * h), 0.0, 1.0, 1.0]
	return (
		PackedFloat32Array(
			(
				pbd_motion
				+ [
					load.x,
					load.y,
					load.z,
					20.0 * h,
					p_iterations,
					1.0,
					0.02,
					p_method,  # contact
					h,
					1.0,
					bending,
					0.2 * w,  # chain
					1.0 / (h * h),
					w * w,
					w * w,
					0.0,  # energy
					p_tile_size,
					p_tiles,
					p_tiles,
					p_knots,  # field
					1.6,
					0.0,
					0.0,
					0.0,  # clump
				]
				+ free_motion
			)
		)
		. to_byte_array()
	)


## Returns a patch of leaning blades, p_length metres long, as texels of 16-bit floats.
static func patch_texels(p_width: int, p_blades: int, p_knots: int, p_length: float) -> PackedByteArray:
	var row := p_width / p_knots
	var image := Image.create_empty(p_width, p_blades / row, false, Image.FORMAT_RGBAH)
	for blade in p_blades:
		var at := Vector2i(blade % row, blade / row)
		image.set_pixelv(at, Color(fmod(blade * 0.618034, 1.0), fmod(blade * 0.7548777, 1.0), 0.0))
		for knot in range(1, p_knots):
			var along := float(knot) / (p_knots - 1)
			var lean := 0.3 * along * along * p_length
			image.set_pixelv(at + Vector2i(knot * row, 0), Color(lean * cos(blade), p_length * along, lean * sin(blade)))
	return image.get_data()
