# SPDX-License-Identifier: MIT
## The limits of the card: the same sums in fragments, in vertices and in a compute shader. Some cards shade on a small part of the units
## that they compute on, so compare times of drawing with these.
extends Node

const Measure := preload("res://bench/measure.gd")
const ROUNDS := 4096  # of 16 multiplications and 16 additions each, by a thread
const SOFTWARE_ROUNDS := 16
const VERTICES := 3 << 16
const GROUPS := 8192  # of compute threads
const GROUP := 64
const FRAMES := 12
const SUMS := """
	vec4 a = vec4(p_seed), b = a + 0.1, c = a + 0.2, d = a + 0.3;
	for (int i = 0; i < %d; i++) {
		a = a * b + c;
		b = b * c + d;
		c = c * d + a;
		d = d * a + b;
	}
	return dot(a + b, c + d);
"""

var _rounds: int


func run(p_software: bool) -> Array[PackedStringArray]:
	_rounds = SOFTWARE_ROUNDS if p_software else ROUNDS
	var rows: Array[PackedStringArray] = [["stage", "threads", "gpu_ms", "tera_operations_a_second"]]
	var size := Vector2i(256, 256) if p_software else Vector2i(1920, 1080)
	rows.append(_row("fragments", size.x * size.y, await _time_drawn(size, "fragment", "COLOR = vec4(sums(UV.x * 0.1))", _square(size))))
	var vertices := VERTICES / 64 if p_software else VERTICES
	rows.append(_row("vertices", vertices, await _time_drawn(size, "vertex", "VERTEX = vec2(sums(VERTEX.x))", _points(vertices))))
	var groups := GROUPS / 64 if p_software else GROUPS
	rows.append(_row("compute", groups * GROUP, await _time_computed(groups)))
	return rows


func _row(p_stage: String, p_threads: int, p_ms: float) -> PackedStringArray:
	var operations := 32.0 * _rounds * p_threads
	return [p_stage, str(p_threads), "%.4f" % p_ms, "%.3f" % (operations / maxf(p_ms, 1e-6) * 1e-9)]


## Returns milliseconds that p_mesh takes longer with the sums than without.
func _time_drawn(p_size: Vector2i, p_stage: String, p_code: String, p_mesh: Mesh) -> float:
	var view := SubViewport.new()
	view.size = p_size
	view.disable_3d = true
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var drawn := MeshInstance2D.new()
	drawn.mesh = p_mesh
	drawn.material = ShaderMaterial.new()
	view.add_child(drawn)
	add_child(view)
	RenderingServer.viewport_set_measure_render_time(view.get_viewport_rid(), true)
	var times: Array[float] = []
	for rounds: int in [1, _rounds]:
		var shader := Shader.new()
		var sums := "float sums(float p_seed) {%s}" % (SUMS % rounds)
		shader.code = "shader_type canvas_item;\n%s\nvoid %s() { %s; }" % [sums, p_stage, p_code]
		drawn.material.shader = shader
		var measured: Array[float] = []
		for frame in FRAMES:
			await RenderingServer.frame_post_draw
			if frame >= FRAMES / 2:
				measured.append(RenderingServer.viewport_get_measured_render_time_gpu(view.get_viewport_rid()))
		times.append(Measure.median(measured))
	view.queue_free()
	return times[1] - times[0]


func _square(p_size: Vector2i) -> Mesh:
	var square := QuadMesh.new()
	square.size = p_size
	square.center_offset = Vector3(0.5 * p_size.x, 0.5 * p_size.y, 0.0)
	return square


## Triangles that are all outside of the picture.
func _points(p_count: int) -> Mesh:
	var places := PackedVector2Array()
	for i in p_count:
		places.append(Vector2(0.1 * i / p_count, 0.0))
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = places
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	return mesh


func _time_computed(p_groups: int) -> float:
	var device := RenderingServer.create_local_rendering_device()
	if device == null:
		return 0.0
	var source := RDShaderSource.new()
	source.source_compute = (
		"""#version 450
layout(local_size_x = %d) in;
layout(set = 0, binding = 0, std430) restrict writeonly buffer Sums { float result[]; };
float sums(float p_seed) {%s}
void main() { result[gl_GlobalInvocationID.x] = sums(float(gl_GlobalInvocationID.x) * 1e-7); }
"""
		% [GROUP, SUMS % _rounds]
	)
	var shader := device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
	var pipeline := device.compute_pipeline_create(shader)
	var results := device.storage_buffer_create(p_groups * GROUP * 4)
	var uniform := RDUniform.new()
	uniform.uniform_type = RenderingDevice.UNIFORM_TYPE_STORAGE_BUFFER
	uniform.add_id(results)
	var bound := device.uniform_set_create([uniform], shader, 0)
	var times: Array[float] = []
	for run in 5:
		device.capture_timestamp("begin")
		var list := device.compute_list_begin()
		device.compute_list_bind_compute_pipeline(list, pipeline)
		device.compute_list_bind_uniform_set(list, bound, 0)
		device.compute_list_dispatch(list, p_groups, 1, 1)
		device.compute_list_end()
		device.capture_timestamp("end")
		device.submit()
		device.sync()
		times.append((device.get_captured_timestamp_gpu_time(1) - device.get_captured_timestamp_gpu_time(0)) * 1e-6)
	for rid: RID in [bound, results, pipeline, shader]:
		if rid.is_valid():
			device.free_rid(rid)
	device.free()
	return Measure.median(times)
