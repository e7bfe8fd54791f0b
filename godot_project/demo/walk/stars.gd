# SPDX-License-Identifier: MIT
## Stars: a picture of the whole sky for the `sky_cover` of a ProceduralSkyMaterial, as clouds.gd makes one for the day.
extends RefCounted

const SIZE := Vector2i(4096, 2048)  # texels, so that a star is no larger than two pixels
const COUNT := 2600
const BRIGHTEST := 1.0
const FAINTEST := 0.06
const LIKE := 5.0  # the more, the fewer stars are bright

static var _cover: ImageTexture


static func cover() -> ImageTexture:
	if _cover == null:
		_cover = ImageTexture.create_from_image(_draw())
	return _cover


static func _draw() -> Image:
	var random := RandomNumberGenerator.new()
	random.seed = 8
	var image := Image.create_empty(SIZE.x, SIZE.y, false, Image.FORMAT_L8)
	for star in COUNT:
		var height := random.randf()  # evenly over half a sphere
		var at := Vector2i(random.randi() % SIZE.x, int(acos(height) / PI * SIZE.y))
		var light := lerpf(FAINTEST, BRIGHTEST, pow(random.randf(), LIKE))
		image.set_pixelv(at, Color(light, light, light))
	return image
