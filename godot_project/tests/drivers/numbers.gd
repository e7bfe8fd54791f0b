# SPDX-License-Identifier: MIT
## Still grass in small pictures, for tools/test/drivers.py, which starts this in each renderer twice under the layer of tests/drivers/,
## with instances that count from 0 and as they are, and compares the pictures: `-- --folder=FOLDER` is where they go. It has everything
## that is drawn with several levels of detail: shadows, motion vectors, cards, plants, a painted map, a surface hook, several cameras.
extends Node3D

const SIZE := Vector2i(240, 136)
const PATIENCE := 300.0  # seconds
const PRESETS := "res://addons/grass_field/presets/%s.tres"
const HOOK := """void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission) {
	albedo = mix(albedo, vec3(0.5, 0.1, 0.1), s.uv.x * s.height);
}
"""
## The jitter of TAA depends on the frame's number; its picture depends on all frames since it began.
const JITTERS := 16
const TAA_FRAMES := 5

var _folder := ""


func _ready() -> void:
	for argument in OS.get_cmdline_user_args():
		if argument.begins_with("--folder="):
			_folder = argument.trim_prefix("--folder=")
		elif argument.begins_with("--shaders="):
			OS.set_environment("GRASS_LAYER_SHADERS", argument.trim_prefix("--shaders="))  # those of the fields, not the engine's first
	print("GRASS-DRIVERS the instance of a draw call that begins at 5 is %d" % first_instance(5))
	await _draw_plain()
	await _draw_rich()
	print("GRASS-DRIVERS done")
	get_tree().quit()


func _draw_plain() -> void:
	var viewport := _add_viewport(World3D.new())
	var field := _add_field(viewport, {})
	await _shown([field])
	await _save(viewport, "shadows")
	while Engine.get_frames_drawn() % JITTERS != 0:
		await RenderingServer.frame_post_draw
	viewport.use_taa = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	for frame in TAA_FRAMES:
		await RenderingServer.frame_post_draw
	viewport.get_texture().get_image().save_png(_folder.path_join("taa.png"))
	viewport.free()


func _draw_rich() -> void:
	var world := World3D.new()
	var viewport := _add_viewport(world)
	var other := _add_viewport(world)
	other.get_camera_3d().look_at_from_position(Vector3(-4, 2, -7), Vector3(1, 0, 3))
	var map := GrassMap.new()
	map.base_density = 0.7
	var brush := GrassBrush.new()
	brush.tool = GrassBrush.TOOL_HEIGHT
	brush.strength = 1.0
	brush.radius = 4.0
	map.stroke(brush, Vector2(-6, -6), Vector2(6, 6))
	var heights := Image.create_empty(8, 8, false, Image.FORMAT_RF)
	for x in 8:
		for z in 8:
			heights.set_pixel(x, z, Color(0.1 * absi(x - z), 0, 0))
	map.set_ground(heights, Rect2(-8, -8, 16, 16))
	var hook := ShaderInclude.new()
	hook.code = HOOK
	var species: Array[GrassSpecies] = []
	for preset: String in ["daisy", "ox_eye_daisy"]:
		species.append(load(PRESETS % preset))
	var field := _add_field(viewport, {map = map, species = species, surface_hook = hook})
	await _shown([field])
	await _save(viewport, "species")
	other.render_target_update_mode = SubViewport.UPDATE_ONCE
	await RenderingServer.frame_post_draw
	other.get_texture().get_image().save_png(_folder.path_join("camera.png"))
	viewport.free()
	other.free()


func _add_viewport(world: World3D) -> SubViewport:
	var viewport := SubViewport.new()
	viewport.size = SIZE
	viewport.world_3d = world
	viewport.render_target_update_mode = SubViewport.UPDATE_WHEN_VISIBLE  # fields see its camera; it is drawn for its pictures
	add_child(viewport)
	var camera := Camera3D.new()
	viewport.add_child(camera)
	camera.look_at_from_position(Vector3(1, 1.4, 8), Vector3(0, 0, 0))
	return viewport


func _add_field(viewport: SubViewport, properties: Dictionary) -> GrassField:
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-40, 30, 0)
	sun.shadow_enabled = true
	sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
	viewport.add_child(sun)
	var field := GrassField.new()
	field.size = Vector2(16, 16)
	field.density = 100.0
	field.lod_error = 3.0  # several levels on a small field
	field.wind_speed = 0.0
	field.simulated = false
	for property: String in properties:
		field.set(property, properties[property])
	viewport.add_child(field)
	return field


func _shown(fields: Array[GrassField]) -> void:
	var deadline := Time.get_ticks_msec() + PATIENCE * 1000
	while fields.any(func(field: GrassField) -> bool: return not _is_shown(field)) and Time.get_ticks_msec() < deadline:
		OS.delay_msec(50)  # frames without grass only take the time of the threads that make shaders
		await RenderingServer.frame_post_draw


func _is_shown(field: GrassField) -> bool:
	var now := field.get_statistics().merged(field.get_counters())
	return not now.waiting and now.map_waiting == 0 and now.drawn_tiles > 0


func _save(viewport: SubViewport, picture: String) -> void:
	for frame in 2:
		await RenderingServer.frame_post_draw
	viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	await RenderingServer.frame_post_draw
	viewport.get_texture().get_image().save_png(_folder.path_join(picture + ".png"))
	for field: GrassField in viewport.find_children("*", "GrassField", true, false):
		var now := field.get_statistics().merged(field.get_counters())
		print(
			(
				"GRASS-DRIVERS %s: %d tiles and %d for shadows, %d plants, by the %s"
				% [picture, now.drawn_tiles, now.shadow_tiles, now.drawn_plants, now.backend]
			)
		)


## Returns the number that a vertex shader reads for the first instance of an indirect draw call whose firstInstance is `first`.
func first_instance(first: int) -> int:
	var device := RenderingServer.get_rendering_device()
	var format := RDTextureFormat.new()
	format.format = RenderingDevice.DATA_FORMAT_R32_SFLOAT
	format.usage_bits = RenderingDevice.TEXTURE_USAGE_COLOR_ATTACHMENT_BIT | RenderingDevice.TEXTURE_USAGE_CAN_COPY_FROM_BIT
	var texture := device.texture_create(format, RDTextureView.new())
	var framebuffer := device.framebuffer_create([texture])
	var source := RDShaderSource.new()
	source.source_vertex = """#version 450
layout(location = 0) flat out float number;
void main() {
	number = float(gl_InstanceIndex);
	gl_Position = vec4(4.0 * float(gl_VertexIndex / 2) - 1.0, 4.0 * float(gl_VertexIndex % 2) - 1.0, 0.5, 1.0);
}"""
	source.source_fragment = """#version 450
layout(location = 0) flat in float number;
layout(location = 0) out float color;
void main() {
	color = number;
}"""
	var shader := device.shader_create_from_spirv(device.shader_compile_spirv_from_source(source))
	var blend := RDPipelineColorBlendState.new()
	blend.attachments = [RDPipelineColorBlendStateAttachment.new()]
	var pipeline := device.render_pipeline_create(
		shader,
		device.framebuffer_get_format(framebuffer),
		-1,
		RenderingDevice.RENDER_PRIMITIVE_TRIANGLES,
		RDPipelineRasterizationState.new(),
		RDPipelineMultisampleState.new(),
		RDPipelineDepthStencilState.new(),
		blend
	)
	var command := PackedInt32Array([3, 1, 0, first]).to_byte_array()
	var commands := device.storage_buffer_create(command.size(), command, RenderingDevice.STORAGE_BUFFER_USAGE_DISPATCH_INDIRECT)
	var list := device.draw_list_begin(framebuffer, RenderingDevice.DRAW_CLEAR_ALL, PackedColorArray([Color(-1, 0, 0)]))
	device.draw_list_bind_render_pipeline(list, pipeline)
	device.draw_list_draw_indirect(list, false, commands)
	device.draw_list_end()
	var number := device.texture_get_data(texture, 0).decode_float(0)
	for made: RID in [pipeline, shader, framebuffer, commands, texture]:
		device.free_rid(made)
	return int(number)
