# SPDX-License-Identifier: MIT
## What a reader is taken to have when he copies a block: a field, a player and the like, under the names that the pages use.
## Scripts that tools/pages/snippets.py makes of blocks extend this one; stage.tscn, whose root gets such a script, has the nodes.
extends Node3D


class Player:
	extends CharacterBody3D
	var is_crouching := true


var locals := {}  # what the statements of a block declared
var player := Player.new()
var enemy := Node3D.new()
var foot := Node3D.new()
var explosion := Node3D.new()
var from := Vector3(-3, 0, 0)
var to := Vector3(3, 0, 0)
var is_crouching := true
var hay := 0.0  # m³
var drops: Array[Node3D] = [Node3D.new(), Node3D.new(), Node3D.new()]
var looked_along := Vector3.ZERO
var field: GrassField
var map: GrassMap


func _init() -> void:
	var shape := CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	player.add_child(shape)
	for node: Node3D in [player, enemy, foot, explosion] + drops:
		add_child(node)


func _enter_tree() -> void:
	field = $GrassField
	map = field.map


func look_along(direction: Vector3) -> void:
	looked_along = direction
