# SPDX-License-Identifier: MIT
## Compares pictures: godot --headless --script compare.gd -- A B [A B ...]. Prints a JSON object for each pair, in steps of 255: `far`, the
## farthest that two squares of 8 x 8 pixels are apart in a channel; `apart`, the mean of that over all squares; `lighter`, by how much B is
## lighter than A in the square where that is most.
extends SceneTree

const HALVES := 3  # that make a pixel of a square


func _init() -> void:
	var paths := OS.get_cmdline_user_args()
	for i in range(0, paths.size() - 1, 2):
		print(JSON.stringify(compare(shrunk(paths[i]), shrunk(paths[i + 1]))))
	quit()


static func shrunk(p_path: String) -> Image:
	var image := Image.load_from_file(p_path)
	image.convert(Image.FORMAT_RGBAF)
	for half in HALVES:
		image.shrink_x2()
	return image


static func compare(a: Image, b: Image) -> Dictionary:
	if a.get_size() != b.get_size():
		return {error = "%s and %s squares" % [a.get_size(), b.get_size()]}
	var sum := 0.0
	var far := 0.0
	var lighter := 0.0
	for y in a.get_height():
		for x in a.get_width():
			var one := a.get_pixel(x, y)
			var other := b.get_pixel(x, y)
			var most := maxf(absf(one.r - other.r), maxf(absf(one.g - other.g), absf(one.b - other.b)))
			sum += most
			far = maxf(far, most)
			lighter = maxf(lighter, other.get_luminance() - one.get_luminance())
	return {apart = 255.0 * sum / (a.get_width() * a.get_height()), far = 255.0 * far, lighter = 255.0 * lighter}
