# SPDX-License-Identifier: MIT
## Keyboard and gamepad events play the walk: each thing in it has its effect on the grass.
extends "res://tests/case.gd"

const SCENE := "res://demo/walk.tscn"
const Clouds := preload("res://demo/walk/clouds.gd")
const Stars := preload("res://demo/walk/stars.gd")

var walk: Node3D
var field: GrassField
var _held: Array[InputEvent] = []


func open() -> void:
	walk = (load(SCENE) as PackedScene).instantiate()
	walk.size = "tiny"  # on the CPU every tile of a field is looked at in every frame, and a tick costs what is awake
	add_child(walk)
	field = walk.country.field
	await ticks(20)


func after() -> void:
	for event in _held:
		_send(event, false)
	Input.flush_buffered_events()
	if is_instance_valid(walk):
		walk.free()


func key(code: Key) -> InputEventKey:
	var event := InputEventKey.new()
	event.physical_keycode = code
	return event


func button(index: JoyButton) -> InputEventJoypadButton:
	var event := InputEventJoypadButton.new()
	event.button_index = index
	return event


## Returns a stick or trigger, pushed as far as that.
func stick(axis: JoyAxis, value: float) -> InputEventJoypadMotion:
	var event := InputEventJoypadMotion.new()
	event.axis = axis
	event.axis_value = value
	return event


func hold(event: InputEvent) -> void:
	_held.append(event)
	_send(event, true)
	await ticks(1)


func let_go() -> void:
	for event in _held:
		_send(event, false)
	_held.clear()
	await ticks(2)


func tap(event: InputEvent) -> void:
	await hold(event)
	await ticks(1)
	await let_go()


func _send(event: InputEvent, is_pressed: bool) -> void:
	var sent := event.duplicate() as InputEvent
	if sent is InputEventJoypadMotion:
		sent.axis_value = event.axis_value if is_pressed else 0.0
	else:
		sent.pressed = is_pressed
	Input.parse_input_event(sent)


## Returns how far down the grass lies, as a mean over a tile of a square metre: a foot covers a tenth of it.
func lies(place: Vector3) -> float:
	return -field.get_bend_at(place).y


func worn_at(place: Vector3) -> float:
	return field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(place.x, place.z))


func are_knots_finite() -> bool:
	var tiles := field.get_grid_size()
	var awake := 0
	for z in tiles.y:
		for x in tiles.x:
			if field.is_tile_awake(Vector2i(x, z)):
				awake += 1
				for knot in field.get_tile_knots(Vector2i(x, z)):
					if not knot.is_finite():
						return false
	return awake > 0


func test_on_foot() -> void:
	await open()
	var walker: CharacterBody3D = walk.walker
	assert_true(walker.is_on_floor(), "it stands on the hills")
	var start := walker.global_position
	await hold(key(KEY_W))
	var most := 0.0
	for i in 60:
		await ticks(1)
		most = maxf(most, lies(walker.global_position))
	assert_greater(start.z - walker.global_position.z, 2.0, "W walks")
	assert_greater(most, 0.04, "the grass lies under who walks")
	assert_greater(field.get_awake_tile_count(), 3)
	assert_true(are_knots_finite(), "knots are numbers")
	await let_go()
	assert_greater(worn_at(start + Vector3(0, 0, -0.8)) + worn_at(start + Vector3(0, 0, -1.6)), 0.01, "footprints")
	var at := walker.global_position
	await hold(stick(JOY_AXIS_LEFT_X, -1.0))
	await ticks(40)
	await let_go()
	assert_greater(at.x - walker.global_position.x, 1.0, "the left stick walks")
	var yaw: float = walk.eye.yaw
	await hold(stick(JOY_AXIS_RIGHT_X, 1.0))
	await ticks(20)
	await let_go()
	assert_less(walk.eye.yaw, yaw - 0.5, "the right stick looks around")
	await hold(button(JOY_BUTTON_A))
	await ticks(8)
	assert_greater(walker.velocity.y, 0.5, "it jumps")


func test_the_ball_is_kicked() -> void:
	await open()
	var ball: RigidBody3D = walk.ball
	walk.walker.global_position = walk.hills.on_ground(walk.BALL + Vector3(0, 0, 2), 0.05)
	var start := ball.global_position
	await hold(key(KEY_W))
	await hold(key(KEY_SHIFT))
	await ticks(60)
	await let_go()
	assert_greater(walk.walker.kicks, 0)
	assert_greater(ball.global_position.distance_to(start), 3.0)
	assert_greater(start.z, ball.global_position.z, "the way it was kicked")


func test_the_jeep() -> void:
	await open()
	var jeep: VehicleBody3D = walk.jeep
	await ticks(30)
	walk.walker.global_position = walk.hills.on_ground(jeep.get_door(), 0.05)
	await ticks(2)
	assert_greater(lies(wheel_at(jeep, 0)), 0.03, "a wheel presses the grass")
	await tap(button(JOY_BUTTON_Y))
	assert_true(walk.driving, "Y gets in")
	var start := jeep.global_position
	var wheel := wheel_at(jeep, 2)
	assert_less(worn_at(wheel), 0.05, "no track yet")
	await hold(stick(JOY_AXIS_TRIGGER_RIGHT, 1.0))
	var ahead := PackedVector3Array()
	var before := PackedFloat64Array()
	for i in 120:
		ahead.append(wheel_at(jeep, i % 4) + 0.5 * jeep.global_basis.z)
		before.append(worn_at(ahead[i]))
		await ticks(1)
	await let_go()
	var worn := 0.0
	for i in ahead.size():
		worn = maxf(worn, worn_at(ahead[i]) - before[i])
	assert_greater((jeep.global_position - start).dot(jeep.global_basis.z), 4.0, "the trigger drives ahead")
	assert_greater(worn, 0.02, "tracks")
	assert_greater(jeep.global_basis.y.y, 0.8, "on its wheels")
	var way := jeep.global_basis.z
	await hold(key(KEY_W))
	await hold(key(KEY_A))
	await ticks(60)
	assert_greater(way.signed_angle_to(jeep.global_basis.z, Vector3.UP), 0.1, "A steers left")
	await let_go()
	await hold(key(KEY_SPACE))
	for i in 100:
		if jeep.linear_velocity.length() < 0.5:
			break
		await ticks(1)
	assert_less(jeep.linear_velocity.length(), 0.5, "space brakes")
	await let_go()
	await tap(key(KEY_E))
	assert_false(walk.driving, "E gets out")
	assert_true(walk.walker.visible)
	await ticks(30)
	assert_less(walk.walker.global_position.distance_to(jeep.global_position), 4.0)


func wheel_at(jeep: VehicleBody3D, index: int) -> Vector3:
	var wheels := jeep.find_children("*", "VehicleWheel3D", true, false)
	return (wheels[index] as VehicleWheel3D).get_contact_point()


func test_the_mower() -> void:
	await open()
	walk.walker.global_position = walk.hills.on_ground(walk.MOWER + Vector3(0, 0, 1.4), 0.05)
	await ticks(2)
	var place: Vector3 = walk.MOWER + Vector3(0, 0, -1)
	var before := field.get_height_at(place)
	assert_greater(before, 0.15, "it has grown")
	await tap(key(KEY_E))
	assert_true(walk.pushing)
	await hold(key(KEY_W))
	await ticks(90)
	await let_go()
	assert_less(field.get_height_at(place), 0.09, "mown")
	assert_greater(walk.mower.hay, 0.05)
	await tap(key(KEY_E))
	assert_false(walk.pushing)
	var parked: Vector3 = walk.mower.global_position
	await hold(key(KEY_S))
	await ticks(30)
	await let_go()
	assert_eq(walk.mower.global_position, parked, "it stays where it was left")
	assert_less(field.get_height_at(place), 0.09, "and the grass stays cut")
	await tap(key(KEY_R))
	assert_near(field.get_height_at(place), before, 0.03, "R lets it grow again")


func test_a_blast() -> void:
	await open()
	await ticks(40)
	var awake := field.get_awake_tile_count()
	var ball: RigidBody3D = walk.ball
	var place: Vector3 = walk.walker.global_position + Vector3(0, 0, -walk.THROW)
	ball.global_position = walk.hills.on_ground(place + Vector3(1.5, 0, 0), 0.3)
	ball.linear_velocity = Vector3.ZERO
	await tap(button(JOY_BUTTON_X))
	await ticks(12)
	assert_eq(field.get_counters().forces, 1)
	assert_greater(field.get_awake_tile_count(), awake + 60, "it wakes what it reaches")
	assert_greater(field.get_bend_at(walk.hills.on_ground(place + Vector3(2, 0, 0))).x, 0.2, "away from it")
	assert_less(field.get_bend_at(walk.hills.on_ground(place + Vector3(-2, 0, 0))).x, -0.2)
	assert_greater(ball.linear_velocity.x, 2.0, "the ball flies")
	assert_true(are_knots_finite(), "knots are numbers")


func test_weather() -> void:
	await open()
	var seen: Array[String] = []
	var jump := 0.0
	for i in 3:
		await tap(key(KEY_G) if i != 1 else button(JOY_BUTTON_DPAD_RIGHT))
		seen.append(walk.weather.kind)
		for tick in 120:
			var before := Vector3(field.wind_speed / 10.0, field.wetness, field.snow)
			await ticks(1)
			jump = maxf(jump, before.distance_to(Vector3(field.wind_speed / 10.0, field.wetness, field.snow)))
		match walk.weather.kind:
			"windy":
				assert_greater(field.wind_speed, 4.0)
				assert_greater(field.gust_strength, 0.7)
			"rain":
				assert_greater(field.wetness, 0.2)
			"snow":
				assert_greater(field.snow, 0.1)
	assert_eq(seen, ["windy", "rain", "snow"] as Array[String])
	assert_less(jump, 0.01, "nothing jumps from tick to tick")
	assert_greater(jump, 0.0)
	for each: GrassField in walk.country.fields:
		assert_eq(each.snow, field.snow, "the same snow lies on all fields")


func test_quality() -> void:
	await open()
	var levels: Array[int] = []
	for i in 4:
		await tap(key(KEY_Q) if i != 1 else button(JOY_BUTTON_DPAD_DOWN))
		levels.append(GrassQuality.get_level())
	assert_eq(levels, [3, 0, 1, 2] as Array[int])
	await ticks(20)
	assert_true(walk.panel.text().contains("blades drawn, high"))
	await tap(key(KEY_Q))
	walk.free()
	assert_eq(GrassQuality.get_level(), GrassQuality.LEVEL_HIGH, "the walk leaves nothing behind")


func test_day_and_night() -> void:
	await open()
	var sun: DirectionalLight3D = walk.get_node("Sun")
	var morning := sun.global_basis.z
	var energy := sun.light_energy
	assert_false(walk.day.is_dark())
	var sky: ProceduralSkyMaterial = walk.get_node("World").environment.sky.sky_material
	assert_eq(sky.sky_cover, Clouds.cover(), "clouds by day")
	await hold(key(KEY_T))
	var most := 0.0
	for i in 440:
		var before := sun.light_energy
		await ticks(1)
		most = maxf(most, absf(sun.light_energy - before))
		if i == 200:
			assert_greater(sun.global_basis.z.angle_to(morning), 0.4, "the sun moves")
	await let_go()
	assert_true(walk.day.is_dark(), "it is night at %.1f" % walk.day.hour)
	assert_less(sun.light_energy, 0.4 * energy, "the moon is weaker")
	assert_eq(sky.sky_cover, Stars.cover(), "stars by night")
	assert_greater(sky.sky_cover_modulate.a, 0.5, "that shine")
	assert_less(most, 0.2, "no jump of the light")
	assert_true(walk.eye.lamp.visible, "a lamp by night")
	await tap(key(KEY_L))
	assert_false(walk.eye.lamp.visible, "and a key for it")


func test_help_and_view() -> void:
	await open()
	await tap(key(KEY_H))
	assert_false(walk.panel.visible)
	await tap(key(KEY_H))
	await ticks(20)
	assert_true(walk.panel.visible)
	assert_true(walk.panel.text().contains("tiles awake"))
	await tap(key(KEY_V))
	await ticks(2)
	assert_greater(walk.eye.global_position.distance_to(walk.walker.get_head()), 1.0, "from behind")
