# SPDX-License-Identifier: MIT
## The pictures of the demo's benchmark are as expected in each renderer, and it would notice if something in them were missing.
extends "res://tests/view_case.gd"

const Expected := preload("res://demo/benchmark/expected.gd")
const Pictures := preload("res://demo/benchmark/pictures.gd")


## The benchmark draws its view while threads make shaders, which takes the processors from them: here they are made before.
func make_shaders(pictures: Pictures) -> void:
	for name: String in Expected.cells():
		var field := pictures._field(name)
		viewport.add_child(field)
		await fields_shown()
		await seen()  # a body that lies in the grass needs passes of its own
		await compiled(field)
		field.free()


func test_pictures_are_as_expected() -> void:
	var pictures := Pictures.new()
	await make_shaders(pictures)
	var made := await pictures.take(self, true)
	assert_eq(made.size(), 3)
	for name: String in made:
		print("    %s: %.4f off, %s" % [name, made[name].difference, made[name].cells])
		assert_true(made[name].alike, name)
		for other: String in pictures.images:
			if other != name:  # as if the hole, the dent or the flowers were missing
				var off := Pictures.difference(Pictures.colors(pictures.images[other]), Expected.cells()[name].hex_decode())
				assert_greater(off, 1.5 * Pictures.ALIKE, "%s instead of %s" % [other, name])
