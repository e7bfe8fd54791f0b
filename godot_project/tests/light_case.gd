# SPDX-License-Identifier: MIT
## A test that compares how light grass is at several distances: a long field on which the light of the tests falls.
extends "res://tests/view_case.gd"

const SIZE := Vector2i(640, 720)  # narrow: beside the field there would be sky from 90 m on
const EYE := 1.7  # metres above the ground
const HALF := 200.0  # metres, of the field
const WINDOW := 1.2  # metres that a reference is high, at least
const LOD_FAR := 100.0  # as fields have it
## Ambient light, and the sun's angle to the direction of view; INF: no sun.
const LIGHTS := {sky = [1.0, INF], front = [0.35, 0.0], side = [0.35, 90.0], back = [0.35, 180.0]}
const DISTANCES: Array[float] = [3.0, 8.0, 18.0, 40.0, 90.0, 200.0, 300.0]

var sun: DirectionalLight3D
var world: WorldEnvironment


func before() -> void:
	open_view(SIZE)
	camera.far = 420.0
	sun = DirectionalLight3D.new()
	viewport.add_child(sun)
	world = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color(0.4, 0.5, 0.7)
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color.WHITE
	viewport.add_child(world)


func set_light(name: String) -> void:
	var angle: float = LIGHTS[name][1]
	world.environment.ambient_light_energy = LIGHTS[name][0]
	sun.visible = is_finite(angle)
	sun.rotation_degrees = Vector3(-40, angle if is_finite(angle) else 0.0, 0)


## Adds a field of one kind of grass that nothing moves: it is the same everywhere.
func add_even_field() -> GrassField:
	var even := {clump_height = 0.0, clump_lean = 0.0, clump_tint = 0.0}
	return add_seen_field(even.merged({size = Vector2(2.0, 2.0) * HALF}))


func look_ahead() -> void:
	camera.fov = 75.0
	look(Vector3(0, EYE, HALF - 2.0), Vector3(0, EYE - 3.0, HALF - 12.0))


## Mean luminance of the grass around each of DISTANCES, in a picture of what is ahead.
func profile_of(image: Image) -> PackedFloat32Array:
	var means := PackedFloat32Array()
	for distance in DISTANCES:
		means.append(light_of(image, distance, SIZE.x / 6, SIZE.x * 5 / 6))
	return means


## The same of one of them, by light, as pictures would have it that resolve each blade, with 16 samples a pixel: through a lens under
## which all blades are drawn that something else does not hide, and as wide as they are.
func references(field: GrassField, distance: float) -> Dictionary[String, float]:
	field.lod_far = 10000.0
	viewport.size = Vector2i(SIZE.x / 2, SIZE.y / (4 if distance < LOD_FAR else 2))
	viewport.msaa_3d = Viewport.MSAA_4X
	camera.far = 1.3 * distance + 2.0
	camera.fov = maxf(rad_to_deg(2.0 * atan(0.5 * WINDOW / distance)), 1.0)
	look(Vector3(0, EYE, HALF - 2.0), Vector3(0, 0.25, HALF - 2.0 - distance))
	await ready_for_picture()
	var lights: Dictionary[String, float] = {}
	for light: String in LIGHTS:
		set_light(light)
		lights[light] = light_of(await next_picture(), distance, 0, viewport.size.x)
	field.lod_far = LOD_FAR
	return lights


## Mean luminance of the grass at `distance`, and a share nearer and farther, within columns of a picture.
func light_of(image: Image, distance: float, from: int, to: int, share := 0.15) -> float:
	var low := row_of(image, (1.0 - share) * distance)
	var high := row_of(image, (1.0 + share) * distance)
	var sum := 0.0
	var count := 0
	for y in range(maxi(floori(high), 0), mini(maxi(ceili(low), floori(high) + 1), image.get_height())):
		for x in range(from, to):
			sum += image.get_pixel(x, y).srgb_to_linear().get_luminance()
			count += 1
	return sum / maxi(count, 1)


## Returns the row of a picture in which the grass at a distance appears.
func row_of(image: Image, distance: float) -> float:
	return camera.unproject_position(Vector3(0, 0.25, HALF - 2.0 - distance)).y / viewport.size.y * image.get_height()
