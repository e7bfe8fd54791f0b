# SPDX-License-Identifier: MIT
## The views of the gallery: the place of the camera, the light and the scene. Metres and degrees. The camera looks along -Z unless there is
## a `target`; `sun` is the sun's height and its direction seen from the camera: 0 in front, 90 on the right, 180 behind.
extends RefCounted

const EYE := Vector3(0, 1.7, 18)
const AHEAD := Vector3(0, 0.9, 6)

const DEFAULTS := {place = "meadow", eye = EYE, target = AHEAD, fov = 60.0, sun = Vector2(45, 120), sky = "clear", with = []}

const ALL := {
	eye_level = {about = "Eye level, the sun at 45 degrees from the side"},
	ground = {about = "A beetle's view", eye = Vector3(0, 0.12, 12), target = Vector3(0, 0.3, 4), fov = 70.0},
	close = {about = "From 40 cm", eye = Vector3(0.3, 0.75, 10.2), target = Vector3(0, 0.4, 9.6), fov = 45.0, sun = Vector2(45, 60)},
	ten_metres = {about = "From 10 m", eye = Vector3(0, 10, 30), target = Vector3(0, 0, 8)},
	sixty_metres = {about = "From 60 m", eye = Vector3(0, 60, 30), target = Vector3(0, 0, 0)},
	telephoto = {about = "Telephoto, 8 degrees", eye = Vector3(0, 2.5, 60), target = Vector3(0, 0.6, 0), fov = 8.0},
	low_sun = {about = "The sun at 12 degrees, from the side", sun = Vector2(12, 90)},
	against_the_sun = {about = "Against the sun at 12 degrees", sun = Vector2(12, 10)},
	overcast = {about = "Overcast", sky = "overcast"},
	night =
	{about = "Night: two lamps and a torch", sky = "night", with = ["lamps"], eye = Vector3(0, 1.7, 10), target = Vector3(0, 0.6, 0)},
	fog = {about = "Fog", sun = Vector2(20, 40), with = ["fog"]},
	volumetric_fog = {about = "Volumetric fog, against the sun", sun = Vector2(18, 15), with = ["volumetric_fog", "walls"]},
	sdfgi =
	{
		about = "SDFGI: red and white walls light the grass",
		with = ["sdfgi", "walls"],
		eye = Vector3(0, 1.7, 9),
		target = Vector3(0, 0.7, 0)
	},
	voxel_gi = {about = "VoxelGI, the same walls", with = ["voxel_gi", "walls"], eye = Vector3(0, 1.7, 9), target = Vector3(0, 0.7, 0)},
	light_probes =
	{
		about = "Light probes of a lightmap, the same walls; no sun",
		place = "plots",
		sky = "shade",
		with = ["light_probes", "walls"],
		eye = Vector3(0, 1.7, 7),
		target = Vector3(0, 0.4, 1)
	},
	decal = {about = "A decal", with = ["decal"], eye = Vector3(0, 3, 10), target = Vector3(0, 0, 2)},
	plants = {about = "Ferns, daisies and shrubs with meshes", place = "plants", eye = Vector3(0, 1.5, 12), target = Vector3(0, 0.4, 6)},
	snow = {about = "Snow", sun = Vector2(25, 100), with = ["snow"]},
	rain = {about = "After rain, against the sun", sun = Vector2(30, 20), with = ["rain"]},
	hills = {about = "Hills", place = "hills", eye = Vector3(-14, 8, 40), target = Vector3(4, 1, 0)},
	painted = {about = "A painted path and stands of tall grass", place = "painted", eye = Vector3(-2, 4, 22), target = Vector3(0, 0, 4)},
	far_field = {about = "One kilometre", place = "kilometre", eye = Vector3(0, 1.9, 480), target = Vector3(0, 1.2, 440)},
	border = {about = "The border", place = "border", eye = Vector3(-8, 1.7, 121), target = Vector3(4, 0.3, 113)},
}


static func of(name: String) -> Dictionary:
	return DEFAULTS.merged(ALL[name], true)


## Returns the text beside a picture, one fact an entry.
static func settings(name: String) -> PackedStringArray:
	var view := of(name)
	var facts := PackedStringArray(["eye at %s m, %d degrees" % [String.num(view.eye.y, 2), view.fov]])
	if view.sky == "clear":
		facts.append("sun %d degrees high, %d from ahead" % [view.sun.x, view.sun.y])
	else:
		facts.append("sky: " + view.sky)
	if not view.with.is_empty():
		facts.append("with " + ", ".join(view.with))
	return facts
