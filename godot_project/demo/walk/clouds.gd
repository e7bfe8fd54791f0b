# SPDX-License-Identifier: MIT
## Thin fair-weather clouds, drawn out by high winds: a picture of the whole sky for the `sky_cover` of a ProceduralSkyMaterial, which adds
## it to the sky.
extends RefCounted

# Texels: all around, from the zenith to the horizon and, cloudless, to the nadir. They are square, or clouds look combed.
const SIZE := Vector2i(1024, 512)
const LIGHT := Color(0.95, 0.93, 0.9)
const WINDS := Vector2(0.5, 1.5)  # they draw clouds out along one way
const THINNEST := 0.02  # height of the clouds' far edge in the sky, 0 at the horizon to 1 at the zenith

static var _cover: ImageTexture


static func cover() -> ImageTexture:
	if _cover == null:
		_cover = ImageTexture.create_from_image(_draw())
	return _cover


static func _draw() -> Image:
	var noise := FastNoiseLite.new()
	noise.noise_type = FastNoiseLite.TYPE_SIMPLEX
	noise.seed = 3
	noise.frequency = 0.3
	noise.fractal_octaves = 5
	noise.fractal_gain = 0.5
	noise.domain_warp_enabled = true
	noise.domain_warp_type = FastNoiseLite.DOMAIN_WARP_SIMPLEX
	noise.domain_warp_amplitude = 1.6
	noise.domain_warp_frequency = 0.35
	var image := Image.create(SIZE.x, SIZE.y, false, Image.FORMAT_RGBA8)
	for y in SIZE.y >> 1:
		var angle := PI * (y + 0.5) / SIZE.y
		var reach := tan(angle) / (1.0 + 0.12 * tan(angle))  # a flat layer, bent down a little at the horizon
		var fades := smoothstep(THINNEST, 0.16, cos(angle))
		for x in SIZE.x:
			var at := Vector2.from_angle(TAU * (x + 0.5) / SIZE.x) * reach
			var thick := smoothstep(-0.05, 0.75, noise.get_noise_2dv(at.rotated(0.6) * WINDS))
			image.set_pixel(x, y, Color(LIGHT, 0.7 * fades * thick))
	image.generate_mipmaps()
	return image
