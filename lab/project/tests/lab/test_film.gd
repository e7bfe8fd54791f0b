# SPDX-License-Identifier: MIT
## Each shot of the film shows what it is about from its first frame to its last, and the grass moves in it.
extends "res://tests/case.gd"

const Film := preload("res://demo/film/film.gd")

const TICKS := 20  # a second: what a shot shows is the same, and on the CPU the country's grass takes a third of the time

var film: Film


func before() -> void:
	Engine.physics_ticks_per_second = TICKS
	film = (load("res://demo/film.tscn") as PackedScene).instantiate()
	film.size = "tiny"
	var screen := SubViewport.new()
	screen.size = Vector2i(1280, 720)
	add_child(screen)
	screen.add_child(film)
	await ticks(5)


func after() -> void:
	film.get_parent().free()
	Engine.physics_ticks_per_second = 60


func test_every_shot_has_its_subject_in_view() -> void:
	var camera: Camera3D = film.get_node("Camera")
	for name: String in Film.SHOTS:
		film.show_shot(name)
		var shot: Film.Shot = film.shot
		assert_less(shot.seconds, 4.0, name)
		var most := 0
		for share: float in [0.05, 0.5, 0.95]:
			while shot.time < share * shot.seconds:
				await ticks(1)
				most = maxi(most, film.stage.country.field.get_awake_tile_count())
			assert_true(camera.is_position_in_frustum(shot.subject()), "%s at %.2f: its subject is in the picture" % [name, share])
			var above: float = camera.global_position.y - film.stage.hills.height_at(camera.global_position)
			assert_greater(above, 0.5, "%s: the camera is above the grass" % name)
			assert_true(shot.subject().distance_to(camera.global_position) < 20.0, "%s: and near" % name)
		assert_greater(most, 0, "%s: grass moves" % name)


func test_what_shots_leave_behind() -> void:
	film.show_shot("mower")
	var shot: Film.Shot = film.shot
	while shot.time < 1.0:
		await ticks(1)
	var mown: Vector3 = shot.subject() - 1.5 * shot.WAY.normalized()
	var swath: float = film.stage.country.field.get_height_at(mown)
	film.show_shot("gust")
	await ticks(10)
	assert_less(swath, 0.7 * film.stage.country.field.get_height_at(mown), "a swath, which has grown again in the next shot")
	while film.shot.time < 1.5:
		await ticks(1)
	assert_greater(film.stage.country.field.wind_speed, 8.0, "the gust")
