# SPDX-License-Identifier: MIT
## A test that draws species: makes them, and cards for their tips.
extends "res://tests/view_case.gd"

const SIDE := 512  # pixels
const SKY := Color(0.3, 0.4, 0.9)  # of view_case.gd


func before() -> void:
	open_view(Vector2i(SIDE, SIDE))
	add_light()


func make(share: float, color: Color, properties := {}) -> GrassSpecies:
	var species := GrassSpecies.new()
	species.patch = GrassPatch.new()
	species.share = share
	species.root_color = color
	species.tip_color = color
	species.dry = 0.0
	for property: String in properties:
		if property in species.patch:
			species.patch.set(property, properties[property])
		else:
			species.set(property, properties[property])
	return species


## Returns a flower of one colour: a disc on nothing.
func flower(color: Color) -> ImageTexture:
	var image := Image.create_empty(64, 64, false, Image.FORMAT_RGBA8)
	for y in 64:
		for x in 64:
			image.set_pixel(x, y, color if Vector2(x - 31.5, y - 31.5).length() < 30.0 else Color(color, 0.0))
	return ImageTexture.create_from_image(image)


## Twelve white petals about a yellow middle.
func daisy_card() -> ImageTexture:
	var image := Image.create_empty(128, 128, false, Image.FORMAT_RGBA8)
	for y in 128:
		for x in 128:
			var place := Vector2(x - 63.5, y - 63.5) / 64.0
			var petal := absf(cos(6.0 * place.angle()))
			var color := Color(0.95, 0.95, 0.92, 1.0 if place.length() < 0.55 + 0.4 * petal and petal > 0.3 else 0.0)
			image.set_pixel(x, y, Color(0.95, 0.75, 0.1) if place.length() < 0.3 else color)
	return ImageTexture.create_from_image(image)


func is_violet(color: Color) -> bool:
	return color.r > 1.5 * color.g and color.b > 1.5 * color.g
