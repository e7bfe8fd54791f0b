# SPDX-License-Identifier: MIT
## simulate.glsl on a RenderingDevice of its own, for benchmarks: no field, no physics, no frames. One object is one
## number of tiles with their state; the bindings are those of shaders/base/constants.inc.
extends RefCounted

const SimulateData := preload("res://bench/simulate_data.gd")

const BLADES := 64  # a tile
const FRESH := 1  # bit of a slot
const METHODS := 2
const METHOD_BYTE := 44  # of the push constant: GrassStep.contact.w, which step() replaces by the dispatch's first slot
const QUICK_ARRAYS := "NVIDIA"  # whose threads keep joints in arrays of their own, and not in a buffer
const WORK_BYTES := 7 * 16 * BLADES  # of a tile, for each segment of a blade
const SHARED := 32  # colliders that a workgroup shares, at most; more in any tile: the pipeline for crowds
const SLOT_BYTES := 64
const SLOT_WORDS := SLOT_BYTES / 4
const COUNT_BYTE := 24  # of a slot: how many colliders it has
const COLLIDER_BYTES := 96

var device: RenderingDevice
var knots: RID  ## places of the free knots, now and a step before, [slot][half][component][knot][blade], metres
var slots: RID
var colliders: RID

var _pipelines: Array[RID] = []  # by method; then, by method, those for crowds
var _is_crowd := false  # since set_up()
var _shader: RID
var _made: Array[RID] = []  # in the order in which they may be freed
var _set: RID
var _list := -1  # the open compute list
var _steps := 0  # since set_up()
var _pushed := PackedByteArray()


## Null if the machine has no RenderingDevice or the shader cannot be read.
static func make_device() -> RenderingDevice:
	return RenderingServer.create_local_rendering_device()


## Why the shader cannot be used; empty if it can.
func load_shader(p_device: RenderingDevice, p_spirv: String) -> String:
	device = p_device
	var bytes := FileAccess.get_file_as_bytes(p_spirv)
	if bytes.is_empty():
		return "cannot read %s" % p_spirv
	var code := RDShaderSPIRV.new()
	code.set_stage_bytecode(RenderingDevice.SHADER_STAGE_COMPUTE, bytes)
	_shader = device.shader_create_from_spirv(code)
	if not _shader.is_valid():
		return "%s is no shader for this device" % p_spirv
	for crowd: bool in [false, true]:
		for method in METHODS:
			_pipelines.append(make_pipeline(device, _shader, method, crowd))
	return "" if not _pipelines.has(RID()) else "%s makes no pipeline on this device" % p_spirv


## simulate.glsl is compiled for one method, with or without crowds.
static func make_pipeline(p_device: RenderingDevice, p_shader: RID, p_method: int, p_crowd := false) -> RID:
	var method := RDPipelineSpecializationConstant.new()
	method.constant_id = 0
	method.value = p_method
	var tiles := RDPipelineSpecializationConstant.new()
	tiles.constant_id = 1
	tiles.value = int(p_crowd)
	var own_work := RDPipelineSpecializationConstant.new()
	own_work.constant_id = 2
	own_work.value = working_tiles(p_device) == 0
	return p_device.compute_pipeline_create(p_shader, [method, tiles, own_work])


## Returns the most tiles for which the buffer of joints has room; 0: there is no buffer. See count_working_tiles().
static func working_tiles(p_device: RenderingDevice) -> int:
	var vendor := p_device.get_device_vendor_name()
	return 0 if vendor == QUICK_ARRAYS else SimulateData.ROOM


## Bytes of that buffer for p_tiles.
static func work_bytes(p_device: RenderingDevice, p_tiles: int, p_knots: int) -> int:
	return maxi(mini(p_tiles, working_tiles(p_device)) * (p_knots - 1) * WORK_BYTES, 16)


## Makes the buffers of p_tiles tiles with p_knots knots a blade. p_patch: texels of p_format, p_patch_width wide. Empty arguments become
## zeros. p_state: for each tile the places now, then those before. False if the device has no room.
func set_up(
	p_tiles: int,
	p_knots: int,
	p_patch: PackedByteArray,
	p_format: RenderingDevice.DataFormat,
	p_patch_width: int,
	p_slots: PackedByteArray,
	p_colliders := PackedByteArray(),
	p_list := PackedInt32Array(),
	p_state := PackedByteArray()
) -> bool:
	clear()
	_steps = 0
	_is_crowd = range(0, p_slots.size(), SLOT_BYTES).any(func(at: int) -> bool: return p_slots.decode_u32(at + COUNT_BYTE) > SHARED)
	var pool := p_tiles * 2 * 3 * (p_knots - 2) * BLADES * 4
	var texel := 16 if p_format == RenderingDevice.DATA_FORMAT_R32G32B32A32_SFLOAT else 8
	slots = _buffer(p_slots.size(), p_slots)
	colliders = _buffer(p_colliders.size(), p_colliders)
	var list := _buffer(p_list.size() * 4, p_list.to_byte_array())
	var planes := _buffer(16)
	knots = _buffer(pool, p_state)
	var halves := _zeros(p_tiles * 4)
	var twists := _zeros(p_tiles * (maxi(p_knots - 2, 16) + 1) * BLADES * 4)
	var patch := _texture(
		p_format, p_patch_width, p_patch.size() / (texel * p_patch_width), RenderingDevice.TEXTURE_USAGE_SAMPLING_BIT, [p_patch]
	)
	var offsets := PackedByteArray()
	offsets.resize(p_tiles * p_knots * BLADES * 8)
	var pool_texture := _texture(
		RenderingDevice.DATA_FORMAT_R16G16B16A16_SFLOAT, p_knots * BLADES, p_tiles, RenderingDevice.TEXTURE_USAGE_STORAGE_BIT, [offsets]
	)
	var sampler := device.sampler_create(RDSamplerState.new())
	_made.append(sampler)
	var energy := _buffer(p_tiles * 16)  # and bends
	var table := _buffer(p_tiles * 4)
	var growth := _buffer(16)  # no tile has a map
	var work := _buffer(work_bytes(device, p_tiles, p_knots))
	if _made.has(RID()):
		return false
	var uniforms: Array[RDUniform] = []
	var bound: Array[Array] = [
		[slots],
		[colliders],
		[list],
		[planes],
		[knots],
		[halves],
		[sampler, patch],
		[pool_texture],
		[energy],
		[table],
		[growth],
		[],
		[],
		[twists],
		[planes],  # no force blows
		[work]
	]
	for binding in bound.size():
		if bound[binding].is_empty():
			continue  # of fields with species
		var type := RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
		if bound[binding].has(patch):
			type = RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE
		elif bound[binding].has(pool_texture):
			type = RenderingDevice.UNIFORM_TYPE_IMAGE
		uniforms.append(_uniform(binding, type, bound[binding]))
	_set = device.uniform_set_create(uniforms, _shader, 0)
	return _set.is_valid()


## One step of the first p_tiles slots. Steps wait for each other.
func step(p_push: PackedByteArray, p_tiles: int) -> void:
	if _list < 0:
		_list = device.compute_list_begin()
		device.compute_list_bind_compute_pipeline(_list, _pipelines[int(p_push.decode_float(METHOD_BYTE)) + (METHODS if _is_crowd else 0)])
		device.compute_list_bind_uniform_set(_list, _set, 0)
		_pushed = PackedByteArray()
	dispatch(device, _list, p_push, p_tiles)
	_steps += 1


## Adds a step of the first p_tiles slots to an open list, as GpuField::step() does.
static func dispatch(p_device: RenderingDevice, p_list: int, p_push: PackedByteArray, p_tiles: int) -> void:
	var push := p_push.duplicate()
	var room := working_tiles(p_device)
	var most := room if room > 0 else p_tiles
	for first in range(0, p_tiles, most):
		push.encode_float(METHOD_BYTE, first)
		p_device.compute_list_set_push_constant(p_list, push, push.size())
		p_device.compute_list_dispatch(p_list, mini(p_tiles - first, most), 1, 1)
		p_device.compute_list_add_barrier(p_list)


## Returns the half of a tile's knots that holds the places now, after steps that all took time.
func half_now() -> int:
	return _steps % 2


## Ends the open list of steps, as a copy or an upload between steps does.
func pause() -> void:
	if _list >= 0:
		device.compute_list_end()
		_list = -1


## Ends the open list of steps and waits for the device.
func finish() -> void:
	pause()
	device.submit()
	device.sync()


## Wall time of a step, in milliseconds.
func time(p_push: PackedByteArray, p_tiles: int, p_steps: int) -> float:
	var start := Time.get_ticks_usec()
	for i in p_steps:
		step(p_push, p_tiles)
	finish()
	return (Time.get_ticks_usec() - start) * 1e-3 / p_steps


## Frees what set_up() made.
func clear() -> void:
	if _set.is_valid() and device.uniform_set_is_valid(_set):
		device.free_rid(_set)
	_set = RID()
	for rid in _made:
		if rid.is_valid():
			device.free_rid(rid)
	_made.clear()


## Frees everything but the device.
func free_all() -> void:
	clear()
	for rid: RID in _pipelines + [_shader] as Array[RID]:
		if rid.is_valid():
			device.free_rid(rid)
	_pipelines.clear()


## Returns a buffer of its own that clear() frees.
func make_buffer(p_bytes: int) -> RID:
	return _buffer(p_bytes)


func _zeros(p_bytes: int) -> RID:
	var data := PackedByteArray()
	data.resize(p_bytes)
	return _buffer(p_bytes, data)


func _buffer(p_bytes: int, p_data := PackedByteArray()) -> RID:
	var data := p_data
	if data.is_empty() and p_bytes <= 1 << 20:  # zeros; a large one is written before it is read
		data = PackedByteArray()
		data.resize(maxi(p_bytes, COLLIDER_BYTES))
	var rid := device.storage_buffer_create(maxi(p_bytes, data.size()), data)
	_made.append(rid)
	return rid


func _texture(p_format: RenderingDevice.DataFormat, p_width: int, p_height: int, p_usage: int, p_data: Array[PackedByteArray]) -> RID:
	var format := RDTextureFormat.new()
	format.format = p_format
	format.width = p_width
	format.height = p_height
	format.usage_bits = p_usage | RenderingDevice.TEXTURE_USAGE_CAN_UPDATE_BIT
	var rid := device.texture_create(format, RDTextureView.new(), p_data)
	_made.append(rid)
	return rid


func _uniform(p_binding: int, p_type: RenderingDevice.UniformType, p_ids: Array) -> RDUniform:
	var uniform := RDUniform.new()
	uniform.binding = p_binding
	uniform.uniform_type = p_type
	for id: RID in p_ids:
		uniform.add_id(id)
	return uniform
