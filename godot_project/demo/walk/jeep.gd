# SPDX-License-Identifier: MIT
## A jeep with four driven wheels. They press the grass by themselves, and wear it where they slip (the fields' `wheel_wear`). They also
## tread down a little the grass that they roll over.
extends VehicleBody3D

const Look := preload("res://demo/walk/look.gd")
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
const GREEN := Color(0.28, 0.31, 0.2)
const DARK := Color(0.07, 0.07, 0.07)
const STEEL := Color(0.6, 0.6, 0.58)
const LEATHER := Color(0.3, 0.21, 0.13)
const RIM := 0.24  # metres, radius
const SPOKES := 6
## Boxes of the body: size, middle, colour. Those beside the middle are on both sides.
const BODY: Array[Array] = [
	[Vector3(1.3, 0.16, 3.2), Vector3(0.0, 0.56, 0.0), DARK],  # chassis
	[Vector3(1.1, 0.36, 1.2), Vector3(0.0, 0.86, 1.05), GREEN],  # below the bonnet
	[Vector3(1.16, 0.06, 1.24), Vector3(0.0, 1.07, 1.05), GREEN],  # bonnet
	[Vector3(0.5, 0.03, 0.8), Vector3(0.0, 1.11, 1.05), GREEN],
	[Vector3(1.5, 0.3, 0.08), Vector3(0.0, 0.95, 0.46), GREEN],  # dashboard
	[Vector3(0.06, 0.26, 0.9), Vector3(0.72, 0.75, 0.0), GREEN],  # sills and doors
	[Vector3(0.06, 0.44, 1.25), Vector3(0.62, 0.86, -1.05), GREEN],  # walls behind
	[Vector3(1.3, 0.44, 0.06), Vector3(0.0, 0.86, -1.66), GREEN],  # tailgate
	[Vector3(1.4, 0.06, 2.1), Vector3(0.0, 0.66, -0.6), DARK],  # floor
	[Vector3(0.34, 0.05, 0.7), Vector3(0.78, 1.0, 1.22), GREEN],  # fenders
	[Vector3(0.34, 0.28, 0.05), Vector3(0.78, 0.87, 0.85), GREEN],
	[Vector3(0.34, 0.05, 0.8), Vector3(0.78, 1.0, -1.25), GREEN],
	[Vector3(0.34, 0.2, 0.05), Vector3(0.78, 0.9, -0.84), GREEN],
	[Vector3(0.22, 0.05, 1.1), Vector3(0.84, 0.52, 0.0), DARK],  # running boards
	[Vector3(0.5, 0.14, 0.5), Vector3(0.36, 0.86, -0.22), LEATHER],  # seats
	[Vector3(0.5, 0.58, 0.12), Vector3(0.36, 1.18, -0.5), LEATHER],
	[Vector3(0.28, 0.16, 0.1), Vector3(0.36, 1.56, -0.53), LEATHER],
	[Vector3(1.62, 0.14, 0.1), Vector3(0.0, 0.6, 1.78), DARK],  # bumpers
	[Vector3(1.5, 0.12, 0.08), Vector3(0.0, 0.56, -1.74), DARK],
	[Vector3(0.12, 0.12, 0.04), Vector3(0.66, 0.74, -1.7), Color(0.6, 0.05, 0.04)],  # lights behind
	[Vector3(0.1, 0.07, 0.04), Vector3(0.78, 1.05, 1.5), Color(0.9, 0.45, 0.08)],  # indicators
	[Vector3(0.16, 0.12, 0.05), Vector3(0.86, 1.22, 0.5), DARK],  # mirrors
]
## Bars: from, to, colour. Those beside the middle are on both sides.
const BARS: Array[Array] = [
	[Vector3(0.69, 1.07, 0.5), Vector3(0.69, 1.55, 0.46), GREEN],
	[Vector3(-0.69, 1.55, 0.46), Vector3(0.69, 1.55, 0.46), GREEN],
	[Vector3(0.66, 0.7, -0.72), Vector3(0.66, 1.78, -0.72), DARK],
	[Vector3(-0.66, 1.78, -0.72), Vector3(0.66, 1.78, -0.72), DARK],
	[Vector3(0.66, 1.78, -0.72), Vector3(0.66, 1.05, -1.6), DARK],
	[Vector3(0.66, 1.78, -0.72), Vector3(0.69, 1.55, 0.46), DARK],
]
const TREAD := 0.3  # wear by a wheel that rolls over the grass
const TREAD_STEP := 0.3  # metres
const REACH := 3.5  # metres within which one can get in
const DOOR := Vector3(1.9, 0.6, 0.2)  # where one gets out

var lamps: Array[SpotLight3D] = []

var _since_tread := 0.0  # metres


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
	_add_tyre(wheel, signf(place.x))
	add_child(wheel, true)


## A tyre with its rim, whose axle is along x. outward: 1 on the left side, -1 on the right one.
func _add_tyre(to: Node3D, outward: float) -> void:
	var tyre := TorusMesh.new()
	tyre.outer_radius = RADIUS
	tyre.inner_radius = RIM
	tyre.rings = 32
	tyre.ring_segments = 12
	var ring := Look.add_mesh(to, tyre, Vector3.ZERO, Look.paint(DARK, 0.95))
	ring.rotation.z = 0.5 * PI
	ring.scale.y = 1.35  # wider than it is thick
	_add_disc(to, RIM + 0.03, 0.12, Vector3.ZERO, DARK, Vector3.RIGHT)
	_add_disc(to, 0.07, 0.24, Vector3.ZERO, STEEL, Vector3.RIGHT)
	for i in SPOKES:
		var spoke := Look.add_box(to, Vector3(0.05, RIM, 0.08), Vector3(0.05 * outward, 0.0, 0.0), STEEL, 0.6)
		spoke.rotation.x = TAU * i / SPOKES
		spoke.translate_object_local(Vector3(0.0, 0.5 * RIM, 0.0))


func _add_look() -> void:
	for part: Array in BODY:
		for side: float in [-1.0, 1.0] if (part[1] as Vector3).x != 0.0 else [1.0]:
			Look.add_box(self, part[0], part[1] * Vector3(side, 1.0, 1.0), part[2])
	for bar: Array in BARS:
		for side: float in [-1.0, 1.0] if (bar[0] as Vector3).x > 0.0 else [1.0]:
			var mirrored := Vector3(side, 1.0, 1.0)
			_add_bar(bar[0] * mirrored, bar[1] * mirrored, bar[2])
	for x: float in [-0.52, 0.52]:
		_add_disc(self, 0.13, 0.08, Vector3(x, 0.86, 1.68), STEEL, Vector3.BACK)
		_add_disc(self, 0.11, 0.1, Vector3(x, 0.86, 1.68), Color(0.95, 0.93, 0.85), Vector3.BACK)
	for x: float in [-0.3, -0.15, 0.0, 0.15, 0.3]:
		Look.add_box(self, Vector3(0.06, 0.24, 0.04), Vector3(x, 0.86, 1.68), DARK)
	_add_glass(Vector3(1.34, 0.44, 0.02), Vector3(0.0, 1.31, 0.48))
	var spare := Node3D.new()
	spare.position = Vector3(0.0, 0.98, -1.78)
	spare.rotation.y = 0.5 * PI
	add_child(spare)
	_add_tyre(spare, 1.0)
	var wheel := TorusMesh.new()
	wheel.outer_radius = 0.19
	wheel.inner_radius = 0.16
	Look.add_mesh(self, wheel, Vector3(0.36, 1.22, 0.2), Look.paint(DARK, 0.5)).rotation.x = 1.0


## A disc whose axis is along `axis`: x or z.
func _add_disc(to: Node3D, radius: float, height: float, at: Vector3, color: Color, axis: Vector3) -> void:
	var disc := CylinderMesh.new()
	disc.top_radius = radius
	disc.bottom_radius = radius
	disc.height = height
	disc.radial_segments = 24
	var look := Look.add_mesh(to, disc, at, Look.paint(color, 0.4, 0.4))
	look.rotation = Vector3(0.5 * PI, 0.0, 0.0) if axis == Vector3.BACK else Vector3(0.0, 0.0, 0.5 * PI)


func _add_bar(from: Vector3, to: Vector3, color: Color) -> void:
	var bar := CylinderMesh.new()
	bar.top_radius = 0.03
	bar.bottom_radius = 0.03
	bar.height = from.distance_to(to)
	bar.radial_segments = 10
	var look := Look.add_mesh(self, bar, 0.5 * (from + to), Look.paint(color, 0.5))
	look.basis = Basis(Quaternion(Vector3.UP, from.direction_to(to)))


func _add_glass(size: Vector3, at: Vector3) -> void:
	var pane := BoxMesh.new()
	pane.size = size
	var glass := Look.paint(Color(0.75, 0.85, 0.88, 0.22), 0.05, 0.3)
	glass.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	Look.add_mesh(self, pane, at, glass).cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
