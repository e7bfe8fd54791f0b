# SPDX-License-Identifier: MIT
## The help for the keys, and the state of the walk; a key hides it.
extends CanvasLayer

const EVERY := 0.25  # seconds
const LEVELS := ["low", "medium", "high", "ultra", "own"]
const HELP := """WASD, left stick     walk, drive
mouse, right stick   look
triggers             drive
Shift, left stick    sprint
Space, A             jump, hand brake
E, Y                 jeep, mower
F, X                 blast
G, D-pad right       weather
Q, D-pad down        quality: low to ultra
T, D-pad up          time flies
L, D-pad left        lamp
V, right stick       first, third person
R, Start             begin again
B                    benchmark, three minutes
H, Back              hide this
Esc                  mouse, then quit"""

var _label := Label.new()
var _time := 0.0  # seconds until the text is updated


func _ready() -> void:
	var back := PanelContainer.new()
	var style := StyleBoxFlat.new()
	style.bg_color = Color(0.0, 0.0, 0.0, 0.45)
	style.set_content_margin_all(10.0)
	back.add_theme_stylebox_override("panel", style)
	back.position = Vector2(12.0, 12.0)
	var font := SystemFont.new()
	font.font_names = ["monospace"]
	_label.add_theme_font_override("font", font)
	_label.add_theme_font_size_override("font_size", 12)
	back.add_child(_label)
	add_child(back)


func tell(delta: float, field: GrassField, hour: float, weather: String, hint: String) -> void:
	_time -= delta
	if _time > 0.0 or not visible:
		return
	_time = EVERY
	var facts := field.get_statistics()
	var clock := "%02d:%02d" % [int(hour), int(fmod(hour, 1.0) * 60.0)]
	var lines: Array[String] = [
		"%d fps   %s   %s" % [Engine.get_frames_per_second(), clock, weather],
		"%d tiles awake, %d blades drawn, %s" % [facts.awake_tiles, facts.drawn_blades, LEVELS[GrassQuality.get_level()]],
		hint + "\n",
		HELP
	]
	_label.text = "\n".join(lines)


func text() -> String:
	return _label.text
