# SPDX-License-Identifier: MIT
## A jeep with four driven wheels. They press the grass by themselves, and wear it where they slip (the fields' `wheel_wear`). They also
## tread down a little the grass that they roll over.
extends VehicleBody3D

const Look := preload("res://demo/walk/look.gd")
const JeepLook := preload("res://demo/walk/jeep_look.gd")
const Country := preload("res://demo/walk/country.gd")
const MASS := 900.0  # kg
const POWER := 2400.0  # newtons, of each wheel when it begins to roll; decreases up to the top speed
const TOP_SPEED := 16.0  # m/s
const BRAKE := 60.0
const IDLE_BRAKE := 1.5
const GRIP := 0.9  # friction of a tyre on earth: at full power wheels spin at first
const STEERING := 0.55  # radians at rest, less at speed
const STEER_FAST := 1.8  # radians a second
const RADIUS := 0.4  # metres, of a wheel
const WHEELS: Array[Vector3] = [Vector3(0.78, 0.5, 1.25), Vector3(-0.78, 0.5, 1.25), Vector3(0.78, 0.5, -1.25), Vector3(-0.78, 0.5, -1.25)]
const SPARE := Vector3(0.2, 0.98, -1.92)  # metres, place of the spare wheel
const PANE := Vector3(1.3, 0.4, 0.015)  # metres, of the windscreen
const TREAD := 0.3  # wear by a wheel that rolls over the grass
const TREAD_STEP := 0.3  # metres
const REACH := 3.5  # metres within which one can get in
const DOOR := Vector3(1.9, 0.6, 0.2)  # where one gets out

var lamps: Array[SpotLight3D] = []

var _since_tread := 0.0  # metres
var _tyre: ArrayMesh = JeepLook.wheel(RADIUS)


func _ready() -> void:
	mass = MASS
	center_of_mass_mode = RigidBody3D.CENTER_OF_MASS_MODE_CUSTOM
	center_of_mass = Vector3(0.0, 0.35, 0.0)
	Look.add_shape(self, Look.box(Vector3(1.5, 0.5, 3.3)), Vector3(0.0, 0.75, 0.0))
	for place in WHEELS:
		_add_wheel(place)
	_add_look()
	for x: float in [-0.5, 0.5]:
		lamps.append(Look.add_lamp(self, Vector3(x, 0.85, 1.7), 30.0, 45.0))
		lamps[-1].rotation = Vector3(-0.06, PI, 0.0)  # +z is ahead
	stay()


## Drives for a tick as the player wishes.
func drive(delta: float) -> void:
	var ahead := Input.get_axis("walk_back", "walk_forward") + Input.get_axis("walk_reverse", "walk_throttle")
	go(delta, clampf(ahead, -1.0, 1.0), Input.get_axis("walk_right", "walk_left"), Input.is_action_pressed("walk_jump"))


## Drives for a tick. ahead, left: how far the pedal and the wheel are moved, -1 to 1.
func go(delta: float, ahead: float, left: float, brakes := false) -> void:
	var speed := linear_velocity.dot(global_basis.z)
	var against := ahead * speed < -0.5  # it rolls in the other direction
	engine_force = 0.0 if against else POWER * ahead * maxf(1.0 - absf(speed) / TOP_SPEED, 0.0)
	brake = BRAKE if against or brakes else IDLE_BRAKE if is_zero_approx(ahead) else 0.0
	var wish := left * STEERING / (1.0 + 0.09 * absf(speed))
	steering = move_toward(steering, wish, STEER_FAST * delta)


## Leaves the tracks of this tick.
func tread(delta: float, country: Country) -> void:
	_since_tread += absf(linear_velocity.dot(global_basis.z)) * delta
	if _since_tread < TREAD_STEP:
		return
	_since_tread = 0.0
	for wheel: VehicleWheel3D in find_children("*", "VehicleWheel3D", false, false):
		var field := country.field_at(wheel.get_contact_point())
		if field and wheel.is_in_contact():
			field.trample(wheel.get_contact_point(), 0.36, TREAD)


## Stops driving: nobody is at the wheel.
func stay() -> void:
	engine_force = 0.0
	steering = 0.0
	brake = BRAKE


## Returns the place of somebody who has got out.
func get_door() -> Vector3:
	return global_transform * DOOR


func _add_wheel(place: Vector3) -> void:
	var wheel := VehicleWheel3D.new()
	wheel.position = place
	wheel.wheel_radius = RADIUS
	wheel.wheel_rest_length = 0.18
	wheel.wheel_friction_slip = GRIP
	wheel.wheel_roll_influence = 0.2
	wheel.suspension_travel = 0.25
	wheel.suspension_stiffness = 38.0
	wheel.suspension_max_force = 12000.0
	wheel.damping_compression = 3.5
	wheel.damping_relaxation = 4.5
	wheel.use_as_traction = true
	wheel.use_as_steering = place.z > 0.0
	Look.add_mesh(wheel, _tyre, Vector3.ZERO).rotation.y = 0.0 if place.x > 0.0 else PI  # the outer side is outside
	add_child(wheel, true)


func _add_look() -> void:
	Look.add_mesh(self, JeepLook.body(), Vector3.ZERO)
	Look.add_mesh(self, _tyre, SPARE).rotation.y = 0.5 * PI
	var pane := BoxMesh.new()
	pane.size = PANE
	var glass := Look.paint(Color(0.75, 0.85, 0.88, 0.2), 0.05, 0.3)
	glass.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	var windscreen := Look.add_mesh(self, pane, Vector3(0.0, 1.34, 0.47), glass)
	windscreen.rotation.x = -0.2
	windscreen.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
