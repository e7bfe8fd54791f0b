# SPDX-License-Identifier: MIT
## Runs the problems that lab/core/accuracy/tape.h recorded on the GPU: the reference problems of `./grass bench`, whose errors are
## computed from the knots that this writes. Also times 65,536 swinging blades, by wall time over many steps.
##   bench.tscn -- --only accuracy --packs DIR --spirv DIR --out DIR
## DIR/METHOD_KNOTS.pack, DIR/simulate_KNOTS_free.spv and _edges.spv in, DIR/METHOD_KNOTS.result.gz out; tape.h describes their contents.
extends Node

const SimulateData := preload("res://bench/simulate_data.gd")
const SimulatePass := preload("res://bench/simulate_pass.gd")

const PACK := 0x4b434150
const RESULT := 0x544c5352
const STEP_BYTES := 128
const STEPS_IN_FLIGHT := 400  # then the device is waited for
const TIMED_TILES := 1024  # 65,536 blades
const WARM_UP := 0.2  # seconds: an idle card takes its first steps at a low clock
const BATCH := 20  # frames
const BATCHES := 5
enum Keep { TIP, KNOTS, TIME }

var _device: RenderingDevice
var _passes: Array[SimulatePass] = []  # the one of tiles without colliders, and the one that meets colliders with edges too
var _pass: SimulatePass  # that of the take
var _software := false
var _knots := 0  # of a blade
var _patch := PackedByteArray()
var _states: Array[PackedByteArray] = []  # knots and knots before of each


func run(p_packs: String, p_spirv: String, p_out: String, p_software: bool) -> Array[PackedStringArray]:
	_software = p_software
	var rows: Array[PackedStringArray] = [["pack", "takes", "steps", "seconds", "outcome"]]
	_device = SimulatePass.make_device()
	for file in DirAccess.get_files_at(p_packs):
		if file.get_extension() == "pack":
			var start := Time.get_ticks_msec()
			var row := _play(p_packs.path_join(file), p_spirv, p_out.path_join(file.get_basename() + ".result.gz"))
			rows.append([file, str(row[0]), str(row[1]), "%.1f" % ((Time.get_ticks_msec() - start) * 1e-3), row[2]])
			print(", ".join(rows[-1]))
			await get_tree().process_frame
	if rows.size() == 1:
		push_error(
			"Bench: there are no packs in '%s'. accuracy_16 --record DIR makes them; `./grass bench --only accuracy` does it all." % p_packs
		)
	if _device != null:
		_device.free()
	return rows


## Returns [takes, steps, "ok" or the error].
func _play(p_path: String, p_spirv: String, p_result: String) -> Array:
	var pack := StreamPeerBuffer.new()
	pack.data_array = FileAccess.get_file_as_bytes(p_path)
	if pack.get_size() < 16 or pack.get_u32() != PACK:
		return [0, 0, "no pack"]
	_knots = pack.get_u32()
	var states := pack.get_u32()
	var takes := pack.get_u32()
	_patch = _bytes(pack, SimulatePass.BLADES * _knots * 16)
	_states.clear()
	for i in 2 * states:
		_states.append(_bytes(pack, 3 * (_knots - 2) * SimulatePass.BLADES * 4))
	var error := "no RenderingDevice" if _device == null else ""
	_passes.clear()
	for suffix: String in ["_free", "_edges"]:
		_passes.append(SimulatePass.new())
		if not error:
			error = _passes[-1].load_shader(_device, p_spirv.path_join("simulate_%d%s.spv" % [_knots, suffix]))
	var result := StreamPeerBuffer.new()
	for word: int in [RESULT, _knots, int(_software), takes]:
		result.put_u32(word)
	var steps := 0
	for i in takes:
		if not error:
			steps += _play_take(pack, result)
	for made in _passes if _device != null else []:
		made.free_all()
	if error:
		return [0, 0, error]
	var file := FileAccess.open(p_result, FileAccess.WRITE)
	if file == null or not file.store_buffer(result.data_array.compress(FileAccess.COMPRESSION_GZIP)):
		return [takes, steps, "cannot write %s" % p_result]
	return [takes, steps, "ok"]


## Returns the number of steps.
func _play_take(p_pack: StreamPeerBuffer, r_result: StreamPeerBuffer) -> int:
	var keep := p_pack.get_u32()
	var stride := p_pack.get_u32()
	var state := p_pack.get_u32()
	var steps := p_pack.get_u32()
	var runs := p_pack.get_u32()
	var has_colliders := p_pack.get_u32() != 0
	_pass = _passes[int(has_colliders)]
	var pushes: Array[PackedByteArray] = []
	for run_index in runs:
		var count := p_pack.get_u32()
		var push := _bytes(p_pack, STEP_BYTES)
		for i in count:
			pushes.append(push)
	var colliders: Array[PackedByteArray] = []
	for i in steps if has_colliders else 0:
		colliders.append(_bytes(p_pack, SimulatePass.COLLIDER_BYTES))
	if keep == Keep.TIME:
		var ms := _time(state, pushes, colliders)
		r_result.put_u32(1)
		r_result.put_float(ms)
		return steps
	var kept := _track(state, pushes, colliders, keep, stride)
	r_result.put_u32(kept.size() / 4)
	r_result.put_data(kept)
	return steps


func _set_up(p_tiles: int, p_state: int, p_colliders: int) -> bool:
	var words := PackedInt32Array()
	var state := PackedByteArray()
	for tile in p_tiles:  # all at one place: each has a slot of its own
		words.append_array(SimulateData.slot_words(0, 0, tile, 0, 0, p_colliders, 0))
		state.append_array(_states[2 * p_state])
		state.append_array(_states[2 * p_state + 1])
	return _pass.set_up(
		p_tiles,
		_knots,
		_patch,
		RenderingDevice.DATA_FORMAT_R32G32B32A32_SFLOAT,
		SimulatePass.BLADES * _knots,
		words.to_byte_array(),
		PackedByteArray(),
		[0],
		state
	)


## The part of a take that is kept, as floats.
func _track(
	p_state: int, p_pushes: Array[PackedByteArray], p_colliders: Array[PackedByteArray], p_keep: int, p_stride: int
) -> PackedByteArray:
	if not _set_up(1, p_state, 0 if p_colliders.is_empty() else 1):
		return []
	var size := 4 if p_keep == Keep.TIP else _states[0].size()
	var from := ((_knots - 2) - 1) * SimulatePass.BLADES * 4 if p_keep == Keep.TIP else 0  # x of the last knot of the first blade
	var kept := 0
	var track := _pass.make_buffer(p_pushes.size() / p_stride * size)
	for i in p_pushes.size():
		if p_colliders:
			_pass.pause()
			_device.buffer_update(_pass.colliders, 0, SimulatePass.COLLIDER_BYTES, p_colliders[i])
		_pass.step(p_pushes[i], 1)
		if (i + 1) % p_stride == 0:
			_pass.pause()
			_device.buffer_copy(_pass.knots, track, _pass.half_now() * _states[0].size() + from, kept * size, size)
			kept += 1
		if i % STEPS_IN_FLIGHT == STEPS_IN_FLIGHT - 1:
			_pass.finish()
	_pass.finish()
	return _device.buffer_get_data(track, 0, kept * size)


## Returns milliseconds of a frame, that is of all p_pushes: the best of some batches, as on the CPU. A collider is the same in every step.
func _time(p_state: int, p_pushes: Array[PackedByteArray], p_colliders: Array[PackedByteArray]) -> float:
	var tiles := 8 if _software else TIMED_TILES
	if not _set_up(tiles, p_state, mini(p_colliders.size(), 1)):
		return 0.0
	if p_colliders:
		_device.buffer_update(_pass.colliders, 0, SimulatePass.COLLIDER_BYTES, p_colliders[0])
	var start := Time.get_ticks_msec()
	while Time.get_ticks_msec() - start < WARM_UP * 1e3 and not _software:
		_pass.time(p_pushes[0], tiles, BATCH * p_pushes.size())
	for part in 2:  # now, before
		for tile in tiles:  # back to the start: blades that swing, as on the CPU
			var bytes := _states[2 * p_state + part]
			var half := part if _pass.half_now() == 0 else 1 - part
			_device.buffer_update(_pass.knots, (2 * tile + half) * bytes.size(), bytes.size(), bytes)
	_pass.finish()
	var best := INF
	for batch in 1 if _software else BATCHES:
		best = minf(best, _pass.time(p_pushes[0], tiles, (1 if _software else BATCH) * p_pushes.size()))
	return best * p_pushes.size() * TIMED_TILES / tiles


static func _bytes(p_from: StreamPeerBuffer, p_count: int) -> PackedByteArray:
	return p_from.get_data(p_count)[1]
