# SPDX-License-Identifier: MIT
extends "res://tests/fuzz_case.gd"


## Tiles must go by the pool that the backend has, not by the one that it will have once the patch is made.
func test_a_pool_that_is_wanted_is_not_used_yet() -> void:
	var field := add_field({size = Vector2(SIDE, SIDE), pool_tiles = 16, species = kind({patch = own_patch()})})
	add_balls()
	await ticks(8)
	assert_eq(field.get_awake_tile_count(), 16)
	for i in 6:
		var pool: int = field.get_counters().pool_tiles
		field.species[0].patch.length_max = 0.5 + 0.05 * i
		field.pool_tiles = 4096 if i % 2 == 0 else 16
		field.sleep_delay = 1.1 + 0.1 * i
		if not assert_true(field.get_statistics().waiting):
			return
		assert_eq(field.get_counters().pool_tiles, pool)
		assert_eq(field.get_awake_tile_count(), awake_tiles(field).size(), "while it waits, both speak of the standing field")
		for tick in 8:
			await ticks(1)
			check(field, "round %d, tick %d" % [i, tick])
		await grown(field)
		await ticks(2)
	assert_eq(field.get_counters().pool_tiles, 16)


func test_any_property_in_any_order() -> void:
	for seed_ in 3:
		await fuzz(seed_, 40)
