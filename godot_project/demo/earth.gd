# SPDX-License-Identifier: MIT
## The floor beside and below fields: dry earth with crumbs and pebbles, made of noise. Its colours are those of a field's bare soil.
extends RefCounted

const SIDE := 512  # pixels of a texture
const METRES := 2.5  # that a texture spans
const COLORS: Array[Color] = [Color(0.25, 0.2, 0.14), Color(0.34, 0.28, 0.19), Color(0.42, 0.36, 0.26), Color(0.52, 0.48, 0.4)]
const PATCHES: Array[Color] = [Color(0.72, 0.7, 0.66), Color(1, 0.98, 0.94), Color(1.15, 1.1, 1.0)]
const PATCH_METRES := 11.0

static var _made: StandardMaterial3D


## Returns the material, the same for all floors. Its textures follow the place in the world, whatever the mesh.
static func material() -> StandardMaterial3D:
	if _made == null:
		_made = StandardMaterial3D.new()
		var crumbs := _noise(FastNoiseLite.TYPE_CELLULAR, 0.11)
		_made.albedo_texture = _texture(crumbs, COLORS)
		_made.normal_enabled = true
		_made.normal_texture = _texture(crumbs, [])
		_made.normal_scale = 0.7
		_made.roughness = 1.0
		_made.metallic_specular = 0.1
		_made.uv1_triplanar = true
		_made.uv1_world_triplanar = true
		_made.uv1_scale = Vector3.ONE / METRES
		_made.detail_enabled = true  # no eye finds the square that repeats
		_made.detail_blend_mode = BaseMaterial3D.BLEND_MODE_MUL
		_made.detail_uv_layer = BaseMaterial3D.DETAIL_UV_2
		_made.uv2_triplanar = true
		_made.uv2_world_triplanar = true
		_made.uv2_scale = Vector3.ONE / PATCH_METRES
		_made.detail_albedo = _texture(_noise(FastNoiseLite.TYPE_SIMPLEX_SMOOTH, 0.012), PATCHES)
	return _made


static func _noise(type: FastNoiseLite.NoiseType, frequency: float) -> FastNoiseLite:
	var noise := FastNoiseLite.new()
	noise.noise_type = type
	noise.frequency = frequency
	noise.cellular_return_type = FastNoiseLite.RETURN_DISTANCE2_SUB
	noise.domain_warp_enabled = true
	noise.domain_warp_amplitude = 12.0
	noise.domain_warp_frequency = 0.05
	return noise


## Without colours it is a normal map.
static func _texture(noise: FastNoiseLite, colors: Array[Color]) -> NoiseTexture2D:
	var texture := NoiseTexture2D.new()
	texture.width = SIDE
	texture.height = SIDE
	texture.seamless = true
	texture.generate_mipmaps = true
	texture.as_normal_map = colors.is_empty()
	texture.bump_strength = 6.0
	if colors:
		texture.color_ramp = Gradient.new()
		texture.color_ramp.offsets = range(colors.size()).map(func(i: int) -> float: return float(i) / (colors.size() - 1))
		texture.color_ramp.colors = PackedColorArray(colors)
	texture.noise = noise
	return texture
