# SPDX-License-Identifier: MIT
## The actions of keys and gamepads, registered while the walk runs, so that the project's own list stays empty.
extends RefCounted

const DEADZONE := 0.15
## Keys (by their place on the keyboard), buttons, and axes with their direction.
const ACTIONS := {
	walk_forward = [[KEY_W, KEY_UP], [], [[JOY_AXIS_LEFT_Y, -1.0]]],
	walk_back = [[KEY_S, KEY_DOWN], [], [[JOY_AXIS_LEFT_Y, 1.0]]],
	walk_left = [[KEY_A, KEY_LEFT], [], [[JOY_AXIS_LEFT_X, -1.0]]],
	walk_right = [[KEY_D, KEY_RIGHT], [], [[JOY_AXIS_LEFT_X, 1.0]]],
	walk_look_up = [[], [], [[JOY_AXIS_RIGHT_Y, -1.0]]],
	walk_look_down = [[], [], [[JOY_AXIS_RIGHT_Y, 1.0]]],
	walk_look_left = [[], [], [[JOY_AXIS_RIGHT_X, -1.0]]],
	walk_look_right = [[], [], [[JOY_AXIS_RIGHT_X, 1.0]]],
	walk_throttle = [[], [], [[JOY_AXIS_TRIGGER_RIGHT, 1.0]]],
	walk_reverse = [[], [], [[JOY_AXIS_TRIGGER_LEFT, 1.0]]],
	walk_jump = [[KEY_SPACE], [JOY_BUTTON_A], []],
	walk_sprint = [[KEY_SHIFT], [JOY_BUTTON_LEFT_STICK], []],
	walk_use = [[KEY_E], [JOY_BUTTON_Y], []],
	walk_blast = [[KEY_F], [JOY_BUTTON_X], []],
	walk_weather = [[KEY_G], [JOY_BUTTON_DPAD_RIGHT], []],
	walk_quality = [[KEY_Q], [JOY_BUTTON_DPAD_DOWN], []],
	walk_hurry = [[KEY_T], [JOY_BUTTON_DPAD_UP], []],
	walk_lamp = [[KEY_L], [JOY_BUTTON_DPAD_LEFT], []],
	walk_view = [[KEY_V], [JOY_BUTTON_RIGHT_STICK], []],
	walk_help = [[KEY_H], [JOY_BUTTON_BACK], []],
	walk_reset = [[KEY_R], [JOY_BUTTON_START], []],
	walk_benchmark = [[KEY_B], [], []],
	walk_quit = [[KEY_ESCAPE], [], []],
}


static func register() -> void:
	for action: StringName in ACTIONS:
		if InputMap.has_action(action):
			continue  # the project defines this action itself
		InputMap.add_action(action, DEADZONE)
		for key: Key in ACTIONS[action][0]:
			var event := InputEventKey.new()
			event.physical_keycode = key
			_add(action, event)
		for button: JoyButton in ACTIONS[action][1]:
			var event := InputEventJoypadButton.new()
			event.button_index = button
			_add(action, event)
		for axis: Array in ACTIONS[action][2]:
			var event := InputEventJoypadMotion.new()
			event.axis = axis[0]
			event.axis_value = axis[1]
			_add(action, event)


static func _add(action: StringName, event: InputEvent) -> void:
	event.device = -1  # any keyboard, any gamepad
	InputMap.action_add_event(action, event)
