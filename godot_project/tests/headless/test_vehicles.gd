# SPDX-License-Identifier: MIT
## To the physics server, a vehicle's wheels are rays. The field presses grass with them as with cylinders, and wheels that slip leave
## tracks.
extends "res://tests/field_case.gd"

const WHEELS: Array[Vector3] = [Vector3(1, 0, 1.5), Vector3(-1, 0, 1.5), Vector3(1, 0, -1.5), Vector3(-1, 0, -1.5)]


## Its chassis is above the tips of the grass.
func add_vehicle() -> VehicleBody3D:
	var ground := StaticBody3D.new()
	add_shape(ground, WorldBoundaryShape3D.new())
	add_child(ground)
	var vehicle := VehicleBody3D.new()
	vehicle.mass = 400.0
	var chassis := box(Vector3(1.6, 0.4, 3.2))
	add_shape(vehicle, chassis, Transform3D(Basis(), Vector3(0, 0.7, 0)))
	for place in WHEELS:
		var wheel := VehicleWheel3D.new()
		wheel.position = place + Vector3(0, 0.6, 0)
		wheel.wheel_radius = 0.45
		wheel.wheel_rest_length = 0.3
		wheel.suspension_stiffness = 40.0
		wheel.damping_compression = 4.0
		wheel.damping_relaxation = 5.0
		wheel.use_as_traction = place.z < 0
		vehicle.add_child(wheel)
	vehicle.position.y = 0.6
	add_child(vehicle)
	return vehicle


## Returns how far the grass at a place lies down, shares of its length.
func pressed_at(field: GrassField, place: Vector3) -> float:
	return -field.get_bend_at(place).y


func test_wheels_press_the_grass() -> void:
	var field := add_field({size = Vector2(12, 12)})
	var entered := []
	field.body_entered_grass.connect(entered.append)
	var vehicle := add_vehicle()
	await ticks(180)
	assert_greater(vehicle.position.y, -0.2)
	var wheel: VehicleWheel3D = vehicle.get_child(1)
	assert_true(wheel.is_in_contact(), "it stands on its wheels, at %s" % vehicle.position)
	for child in vehicle.get_children():
		if child is VehicleWheel3D:
			var place: Vector3 = child.global_position
			assert_greater(pressed_at(field, Vector3(place.x, 0, place.z)), 0.05, "below a wheel at %s" % place)
	assert_less(pressed_at(field, Vector3(vehicle.position.x, 0, vehicle.position.z)), 0.02, "below the middle")
	assert_eq(entered, [vehicle], "the vehicle, not its wheels")
	assert_eq(field.get_counters().wheels, 4)
	var awake := field.get_awake_tile_count()
	vehicle.free()
	await ticks(5)
	assert_eq(field.get_counters().wheels, 0)
	await ticks_to_sleep(field)
	assert_greater(awake, 3)


func test_a_vehicle_that_leaves_takes_its_wheels_along() -> void:
	var field := add_field({size = Vector2(12, 12)})
	var vehicle := add_vehicle()
	await ticks(60)
	assert_eq(field.get_counters().wheels, 4)
	vehicle.position.x += 500.0
	await ticks_to_sleep(field)
	assert_eq(field.get_counters().wheels, 0)


func test_wheels_that_slip_leave_tracks() -> void:
	var field := add_field({size = Vector2(12, 12), map = full_map(), wheel_wear = 5.0})
	var vehicle := add_vehicle()
	for child in vehicle.get_children():
		if child is VehicleWheel3D:
			child.wheel_friction_slip = 0.05
	await ticks(90)
	assert_eq(field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(vehicle.position.x + 1, vehicle.position.z - 1.5)), 0.0, "it stands")
	vehicle.engine_force = 4000.0
	await ticks(30)
	var worn := 0.0
	for child in vehicle.get_children():
		if child is VehicleWheel3D:
			worn = maxf(worn, field.map.sample(GrassMap.CHANNEL_WEAR, Vector2(child.get_contact_point().x, child.get_contact_point().z)))
	assert_greater(worn, 0.05)


func test_without_wheel_wear_there_are_no_tracks() -> void:
	var field := add_field({size = Vector2(12, 12)})
	var vehicle := add_vehicle()
	await ticks(60)
	vehicle.engine_force = 4000.0
	await ticks(30)
	assert_true(field.map == null)
