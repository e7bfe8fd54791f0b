# SPDX-License-Identifier: MIT
## The simulation pass alone, without field, physics and frames: tiles of swinging blades, each with its own colliders. Wall time of many
## dispatches, checked against the GPU's own timestamps.
##   bench.tscn -- --only kernel --spirv DIR [--out DIR]
extends Node

const KernelScenes := preload("res://bench/kernel_scenes.gd")
const SimulateData := preload("res://bench/simulate_data.gd")
const SimulatePass := preload("res://bench/simulate_pass.gd")

const TILE_SIZE := 0.5  # metres
const BLADES := 64  # a tile
const KNOTS := 16
const FREE_KNOTS := 14
const PATCH_BLADES := 16384
const LENGTH := 0.5  # of a blade, metres
const STEPS := 200
const WARM_UP := 20
const WAKING := 400  # milliseconds: a card that idled while its driver compiled, or this made buffers, begins at a low clock
const FLOOR_BYTES := 3 * 3 * FREE_KNOTS * 4 + KNOTS * 8  # a blade and step: places now and before read, new ones written; texture
const TWIST_BYTES := 2 * FREE_KNOTS * 4 + 4  # METHOD_DIRECT: twists read and written; length
const TWIST_ROWS := 17  # of a slot
const STRAIN_BYTES := (7 * 2 * 3 + 14 * 3 + 3 * 8) * 4 + KNOTS * 8  # masses now and before, knots; numbers; texture
## The passes of tiles near nothing sharp, near something sharp and without colliders, each with the scenes in which a field would use it.
const SCENES: Dictionary[String, Array] = {"": ["4", "lid", "bodies", "rolling"], "_edges": ["lid", "bodies", "rolling"], "_free": ["0"]}
enum { DIRECT, PBD }
const NAMES: Array[String] = ["DIRECT", "PBD"]
const MOST_TILES := 4096  # with a lid or bodies

var _device: RenderingDevice
var _made: Array[RID] = []
var _pipeline: RID
var _shader: RID
var _strain_pipeline: RID
var _strain_shader: RID


func run(p_spirv: String, p_software: bool) -> Array[PackedStringArray]:
	var rows: Array[PackedStringArray] = [
		["method", "iterations", "awake_blades", "colliders_a_tile", "pass", "wall_ms", "gpu_ms", "floor_bytes_a_blade"]
	]
	_device = RenderingServer.create_local_rendering_device()
	for variant: String in SCENES:
		var code := RDShaderSPIRV.new()
		code.set_stage_bytecode(
			RenderingDevice.SHADER_STAGE_COMPUTE, FileAccess.get_file_as_bytes(p_spirv.path_join("simulate_%d%s.spv" % [KNOTS, variant]))
		)
		_shader = _device.shader_create_from_spirv(code)
		for method: int in [DIRECT, PBD]:
			var start := Time.get_ticks_msec()
			_pipeline = SimulatePass.make_pipeline(_device, _shader, method)
			print(
				"simulate%s, %s: %d ms to compile, unless the driver has kept it" % [variant, NAMES[method], Time.get_ticks_msec() - start]
			)
			# The largest first, so that the clock has risen before the short ones.
			for tiles: int in [64] if p_software else [16384, 4096, 1024]:
				if variant == "_free" and method == DIRECT:
					rows.append(_measure_strains(p_spirv, tiles, 4 if p_software else STEPS))
				for scene: String in SCENES[variant]:
					if scene.length() > 1 and (method == PBD or tiles > MOST_TILES):
						continue
					var row := _measure(method, 2, tiles, scene, 4 if p_software else STEPS)
					row.insert(4, "simulate" + variant)
					rows.append(row)
			_device.free_rid(_pipeline)
		_device.free_rid(_shader)
	_device.free()
	return rows


func _measure(p_method: int, p_iterations: int, p_tiles: int, p_scene: String, p_steps: int) -> PackedStringArray:
	var sets: Array[RID] = []
	var shared := _shared_resources(p_tiles)
	var colliders := int(p_scene) if p_scene.is_valid_int() else 1
	for phase in 8:  # the colliders go to and fro
		sets.append(_uniform_set(shared, p_tiles, p_scene, colliders, phase))
	var bend := SimulateData.push(p_method, KNOTS, TILE_SIZE, 128, Vector3(25.0, 0.0, 10.0), p_iterations)
	var free := SimulateData.push(p_method, KNOTS, TILE_SIZE, 128, Vector3.ZERO, p_iterations)
	if colliders == 1:
		bend = free  # what no body touches stands at rest
	_run(sets, bend, p_tiles, WARM_UP)  # a strong wind bends all blades
	_device.buffer_update(shared[0], 0, p_tiles * SimulatePass.SLOT_BYTES, _slots(p_tiles, colliders, 0))
	var awake := Time.get_ticks_msec() + (0 if p_steps < STEPS else WAKING)
	_run(sets, bend, p_tiles, WARM_UP)
	while Time.get_ticks_msec() < awake:
		_run(sets, bend, p_tiles, WARM_UP)
	_device.capture_timestamp("begin")
	var start := Time.get_ticks_usec()
	_run(sets, free, p_tiles, p_steps)
	var wall := (Time.get_ticks_usec() - start) * 1e-3 / p_steps
	var gpu := 0.0
	for i in _device.get_captured_timestamps_count() - 1:
		gpu = maxf(gpu, (_device.get_captured_timestamp_gpu_time(i + 1) - _device.get_captured_timestamp_gpu_time(i)) * 1e-6)
	for rid in sets:
		_device.free_rid(rid)
	for rid in _made:
		_device.free_rid(rid)
	_made.clear()
	return [
		NAMES[p_method],
		str(p_iterations),
		str(p_tiles * BLADES),
		p_scene,
		"%.4f" % wall,
		"%.4f" % (gpu / p_steps),
		str(FLOOR_BYTES + (TWIST_BYTES if p_method == DIRECT else 0))
	]


## As _measure(), of the pass that moves blades by their strains, from where chains stand at rest.
func _measure_strains(p_spirv: String, p_tiles: int, p_steps: int) -> PackedStringArray:
	var code := RDShaderSPIRV.new()
	code.set_stage_bytecode(RenderingDevice.SHADER_STAGE_COMPUTE, FileAccess.get_file_as_bytes(p_spirv.path_join("strains_%d.spv" % KNOTS)))
	_strain_shader = _device.shader_create_from_spirv(code)
	_strain_pipeline = _device.compute_pipeline_create(_strain_shader)
	var shared := _shared_resources(p_tiles)
	var chains: Array[RID] = [_uniform_set(shared, p_tiles, "0", 0, 0)]
	var bend := SimulateData.push(DIRECT, KNOTS, TILE_SIZE, 128, Vector3(25.0, 0.0, 10.0), 2)
	var free := SimulateData.push(DIRECT, KNOTS, TILE_SIZE, 128, Vector3.ZERO, 2)
	_run(chains, free, p_tiles, 1)
	_device.buffer_update(shared[0], 0, p_tiles * SimulatePass.SLOT_BYTES, _slots(p_tiles, 0, 0))
	var strains: Array[RID] = [_strain_set(shared)]
	var awake := Time.get_ticks_msec() + (0 if p_steps < STEPS else WAKING)
	_run(strains, bend, p_tiles, WARM_UP, _strain_pipeline)
	while Time.get_ticks_msec() < awake:
		_run(strains, bend, p_tiles, WARM_UP, _strain_pipeline)
	_device.capture_timestamp("begin")
	var start := Time.get_ticks_usec()
	_run(strains, free, p_tiles, p_steps, _strain_pipeline)
	var wall := (Time.get_ticks_usec() - start) * 1e-3 / p_steps
	var gpu := 0.0
	for i in _device.get_captured_timestamps_count() - 1:
		gpu = maxf(gpu, (_device.get_captured_timestamp_gpu_time(i + 1) - _device.get_captured_timestamp_gpu_time(i)) * 1e-6)
	for rid in chains + strains + _made + ([_strain_pipeline, _strain_shader] as Array[RID]):
		_device.free_rid(rid)
	_made.clear()
	return ["DIRECT", "2", str(p_tiles * BLADES), "0", "strains", "%.4f" % wall, "%.4f" % (gpu / p_steps), str(STRAIN_BYTES)]


## Bindings of strains.glsl. The section is about that of an even stalk.
func _strain_set(p_shared: Array[RID]) -> RID:
	var numbers := PackedFloat32Array()
	for spring in 2 * 15:
		numbers.append(float(spring % 15 in [0, 2, 5, 9, 14]))  # on the diagonal of a lower half
	for mass in 7:
		numbers.append(1.0 / 7.0)
	var section := _keep([_device.storage_buffer_create(4 * numbers.size(), numbers.to_byte_array())])
	var uniforms: Array[RDUniform] = []
	var buffers := {0: p_shared[0], 1: section[0], 4: p_shared[1], 5: p_shared[2], 8: p_shared[6], 10: p_shared[8], 13: p_shared[9]}
	buffers[14] = section[0]  # no force blows
	for binding: int in buffers:
		uniforms.append(_uniform(binding, RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER, [buffers[binding]]))
	uniforms.append(_uniform(6, RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE, [p_shared[4], p_shared[3]]))
	uniforms.append(_uniform(7, RenderingDevice.UNIFORM_TYPE_IMAGE, [p_shared[5]]))
	return _device.uniform_set_create(uniforms, _strain_shader, 0)


func _run(p_sets: Array[RID], p_push: PackedByteArray, p_tiles: int, p_steps: int, p_pipeline := RID()) -> void:
	_device.capture_timestamp("from")
	var list := _device.compute_list_begin()
	_device.compute_list_bind_compute_pipeline(list, p_pipeline if p_pipeline.is_valid() else _pipeline)
	for step in p_steps:
		_device.compute_list_bind_uniform_set(list, p_sets[step % p_sets.size()], 0)
		SimulatePass.dispatch(_device, list, p_push, p_tiles)
	_device.compute_list_end()
	_device.capture_timestamp("to")
	_device.submit()
	_device.sync()


## Slots (all fresh), knots now and before, which half is which, patch, its sampler, pool texture, energy and bend, tile table, growth (no
## tile has a map), twists, room to work.
func _shared_resources(p_tiles: int) -> Array[RID]:
	var pool := p_tiles * 2 * 3 * FREE_KNOTS * BLADES * 4
	var patch := RDTextureFormat.new()
	patch.format = RenderingDevice.DATA_FORMAT_R16G16B16A16_SFLOAT
	patch.width = KNOTS * BLADES
	patch.height = PATCH_BLADES / BLADES
	patch.usage_bits = RenderingDevice.TEXTURE_USAGE_SAMPLING_BIT
	var pool_texture := RDTextureFormat.new()
	pool_texture.format = patch.format
	pool_texture.width = KNOTS * BLADES
	pool_texture.height = p_tiles
	pool_texture.usage_bits = RenderingDevice.TEXTURE_USAGE_STORAGE_BIT
	return _keep(
		[
			_device.storage_buffer_create(p_tiles * SimulatePass.SLOT_BYTES, _slots(p_tiles, 0, 1)),
			_device.storage_buffer_create(pool),
			_device.storage_buffer_create(p_tiles * 4),
			_device.texture_create(patch, RDTextureView.new(), [_patch_texels()]),
			_device.sampler_create(RDSamplerState.new()),
			_device.texture_create(pool_texture, RDTextureView.new()),
			_device.storage_buffer_create(p_tiles * 16),
			_device.storage_buffer_create(p_tiles * 4),
			_device.storage_buffer_create(16),
			_device.storage_buffer_create(p_tiles * TWIST_ROWS * BLADES * 4),
			_device.storage_buffer_create(SimulatePass.work_bytes(_device, p_tiles, KNOTS)),
		]
	)


## Returns tiles along a side of the square that p_tiles lie in.
func _across(p_tiles: int) -> int:
	return int(sqrt(p_tiles))


func _slots(p_tiles: int, p_colliders: int, p_bits: int) -> PackedByteArray:
	var words := PackedInt32Array()
	var across := _across(p_tiles)
	for tile in p_tiles:
		var blade := (tile * 8) % (PATCH_BLADES - BLADES)
		words.append_array(SimulateData.slot_words(tile % across, tile / across, tile, blade, tile * p_colliders, p_colliders, p_bits))
	return words.to_byte_array()


func _patch_texels() -> PackedByteArray:
	var image := Image.create_empty(KNOTS * BLADES, PATCH_BLADES / BLADES, false, Image.FORMAT_RGBAH)
	for blade in PATCH_BLADES:
		var at := Vector2i(blade % BLADES, blade / BLADES)
		image.set_pixelv(at, Color(fmod(blade * 0.618034, 1.0), fmod(blade * 0.7548777, 1.0), 0.0))
		var place := Vector3.ZERO
		var along := 0.0
		for knot in range(1, KNOTS):  # bent by half a radian, with the clamp of any patch's
			var segment := (0.25 if knot == 1 else 14.75 / 14.0) / 15.0
			place += Vector3.UP.rotated(Vector3(sin(blade), 0.0, -cos(blade)), 0.5 * (along + 0.5 * segment)) * (LENGTH * segment)
			along += segment
			image.set_pixelv(at + Vector2i(knot * BLADES, 0), Color(place.x, place.y, place.z))
	return image.get_data()


func _uniform_set(p_shared: Array[RID], p_tiles: int, p_scene: String, p_colliders: int, p_phase: int) -> RID:
	var lists := PackedInt32Array(range(maxi(1, p_tiles * p_colliders)))
	var colliders := KernelScenes.colliders(p_scene, p_tiles, _across(p_tiles), p_colliders, p_phase)
	var own := _keep(
		[
			_device.storage_buffer_create(colliders.size(), colliders),
			_device.storage_buffer_create(lists.size() * 4, lists.to_byte_array()),
			_device.storage_buffer_create(16 * KernelScenes.HULL_PLANES, KernelScenes.stone()),
		]
	)
	var uniforms: Array[RDUniform] = []
	var buffers: Array[RID] = [p_shared[0], own[0], own[1], own[2], p_shared[1], p_shared[2]]
	for binding in buffers.size():
		uniforms.append(_uniform(binding, RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER, [buffers[binding]]))
	uniforms.append(_uniform(6, RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE, [p_shared[4], p_shared[3]]))
	uniforms.append(_uniform(7, RenderingDevice.UNIFORM_TYPE_IMAGE, [p_shared[5]]))
	for i in 5:
		uniforms.append(_uniform([8, 9, 10, 13, 15][i], RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER, [p_shared[6 + i]]))
	uniforms.append(_uniform(14, RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER, [own[2]]))  # no force blows
	return _device.uniform_set_create(uniforms, _shader, 0)


func _uniform(p_binding: int, p_type: RenderingDevice.UniformType, p_ids: Array[RID]) -> RDUniform:
	var uniform := RDUniform.new()
	uniform.binding = p_binding
	uniform.uniform_type = p_type
	for id in p_ids:
		uniform.add_id(id)
	return uniform


func _keep(p_made: Array[RID]) -> Array[RID]:
	_made.append_array(p_made)
	return p_made
