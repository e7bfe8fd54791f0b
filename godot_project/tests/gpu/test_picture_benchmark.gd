# SPDX-License-Identifier: MIT
## The pictures of the demo's benchmark are as expected in each renderer, and it would notice if something in them were missing.
extends "res://tests/view_case.gd"

const Expected := preload("res://demo/benchmark/expected.gd")
const Pictures := preload("res://demo/benchmark/pictures.gd")


func test_pictures_are_as_expected() -> void:
	var pictures := Pictures.new()
	var made := await pictures.take(self)
	assert_eq(made.size(), 3)
	for name: String in made:
		print("    %s: %.4f off, %s" % [name, made[name].difference, made[name].cells])
		assert_true(made[name].alike, name)
		for other: String in Expected.cells():
			if other != name:  # as if the hole, the dent or the flowers were missing
				var cells := Pictures.colors(pictures.images[name])
				assert_greater(Pictures.difference(cells, Expected.cells()[other].hex_decode()), Pictures.ALIKE, name + other)
