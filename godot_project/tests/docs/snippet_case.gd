# SPDX-License-Identifier: MIT
## A check of one code block: what it must do, on a stage that has what the block assumes.
extends "res://tests/field_case.gd"

const Stage := preload("res://tests/docs/stage.gd")

var block := {}  # {name, key, path}; the runner sets it


func block_script() -> GDScript:
	return load(block.path)


## Returns the stage in the tree, with the block as its script. `setup(stage)` runs before it enters.
func staged(setup := Callable()) -> Stage:
	var stage: Node = load("res://tests/docs/stage.tscn").instantiate()
	stage.set_script(block_script())
	if setup.is_valid():
		setup.call(stage)
	add_child(stage)
	await seen()
	return stage


## Returns the stage after the block's statements.
func ran(setup := Callable()) -> Stage:
	var stage := await staged(setup)
	stage.call("run")
	return stage


## Returns a shape that lies on the stage's field, held still.
func press(stage: Stage, place := Vector3.ZERO) -> AnimatableBody3D:
	var body := add_held_body(ball(0.4), place + Vector3(0, 0.3, 0))
	await seen()
	return body
