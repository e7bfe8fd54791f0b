# SPDX-License-Identifier: MIT
## Ledges across the border of two plots of a world: on ground that a rule leaves bare, and on ground that grows grass.
extends "res://tests/world_case.gd"

const LedgeScene = preload("res://tests/ledge_scene.gd")
const OFF := 0.03  # metres from the ground at which a blade counts as hanging or buried
const NO_LEDGE := 15  # all four heights around a place are of its side
const NEAR := 6.0  # metres around the block that are looked at


## Adds a world whose plots follow a rule of this density, on a floor with a block that lies on the border of two plots, baked.
func add_baked_world(density: float) -> GrassWorld:
	LedgeScene.add_box(self, Vector3(0, -0.5, 0), Vector3(400, 1, 400))
	LedgeScene.add_box(self, Vector3(0.3, 0.5, 20.2), Vector3(4, 1, 3), 0.3)
	await ticks(2)
	var rule := GrassFillRule.new()
	rule.density = density
	var world := add_world({plot_scene = pattern({fill_rule = rule, density = 64.0})})
	await go(world, Vector3(0, 0, 20))
	for plot in both(world):
		plot.bake_ground()
	for plot in both(world):
		await grown(plot)
		await wait_until(func() -> bool: return plot.get_counters().fill_waiting == 0, "the rule has filled it")
	for x: float in [-1.0, 1.0]:  # the block's side lies at z = 22.17 and 21.55 there
		var plot := world.get_field_at(Vector3(x, 0, 20))
		var codes := range(30).map(func(i: int) -> float: return ledge_at(plot, Vector3(x, 0, 21.0 + 0.05 * i)))
		assert_less(codes.min(), float(NO_LEDGE), "the plot of x = %s knows the block's side" % x)
		assert_eq(ledge_at(plot, Vector3(x, 0, 26)), float(NO_LEDGE), "and none on the floor")
	return world


func ledge_at(plot: GrassField, place: Vector3) -> float:
	var local := plot.to_local(place)
	return plot.map.sample(GrassMap.CHANNEL_LEDGE, Vector2(local.x, local.z))


func both(world: GrassWorld) -> Array[GrassField]:
	return [world.get_field_at(Vector3(-1, 0, 20)), world.get_field_at(Vector3(1, 0, 20))]


func test_where_a_rule_forbids_grass_none_stands_at_a_ledge_either() -> void:
	var world: GrassWorld = await add_baked_world(0.0)
	for plot in both(world):
		assert_eq(plot.find_blades(Vector3(0.3, 0, 20.2), NEAR).size(), 0)
	for x in 61:
		for z in 41:
			var place := Vector3(0.1 * x - 3.0, 0, 0.1 * z + 18.2)
			if not assert_eq(world.get_field_at(place).get_density_at(place), 0.0, str(place)):
				return


func test_across_the_border_no_blade_hangs_or_is_buried() -> void:
	var world: GrassWorld = await add_baked_world(1.0)
	var space := get_world_3d().direct_space_state
	var query := PhysicsRayQueryParameters3D.new()
	var off := 0
	var count := 0
	for plot in both(world):
		var blades := plot.find_blades(Vector3(0.3, 0, 20.2), NEAR)
		var knots := plot.get_blade_knots(blades)
		count += blades.size()
		for blade in blades.size():
			var root := knots[blade * KNOTS]
			query.from = Vector3(root.x, 100, root.z)
			query.to = Vector3(root.x, -100, root.z)
			var hit := space.intersect_ray(query)
			off += int(not hit or absf(hit.position.y - root.y) > OFF)
	assert_greater(count, int(0.85 * 64 * PI * NEAR * NEAR), "grass stands nearly everywhere")
	assert_less(float(off), 0.001 * count + 1.0, "%d of %d blades are off the ground" % [off, count])
