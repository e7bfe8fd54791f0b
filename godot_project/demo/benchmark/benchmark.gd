# SPDX-License-Identifier: MIT
## What this machine makes of the grass, in three minutes: B in the demo or the walk begins it, or `-- --place benchmark` behind the
## program's name. It ends with a file, and with a text in the clipboard to paste into a report (docs/guide/machines.md). Esc ends it.
##   --out DIR      writes the files there and ends the program
extends Node3D

signal ended(result: Dictionary)

const Options := preload("res://demo/options.gd")
const Machine := preload("res://demo/benchmark/machine.gd")
const Meter := preload("res://demo/benchmark/meter.gd")
const Parts := preload("res://demo/benchmark/parts.gd")
const Pictures := preload("res://demo/benchmark/pictures.gd")
const Report := preload("res://demo/benchmark/report.gd")
const FOLDER := "user://benchmark"
const SOFTWARE_SHARE := 0.125  # of sides and times where the processor draws
const COMPILING := 120.0  # seconds; the longest time to wait for the driver

## Of the sides and times of the parts, for tests. 0: all of them, or SOFTWARE_SHARE.
@export var share := 0.0
## Where the files go. Empty: FOLDER, or the one in the arguments.
@export var folder := ""

var _part: Parts
var _vsync: DisplayServer.VSyncMode
var _msaa: Viewport.MSAA

@onready var _words: Label = $Screen/Back/Words


func _ready() -> void:
	_begin()
	var result := {version = 1, grass = GrassField.get_version(), machine = Machine.describe(), share = share, parts = {}, pictures = {}}
	for part in Parts.PARTS:
		_words.text = "Measuring: %s …\nEsc ends it." % part.words
		result.parts[part.name] = await _measure(part)
		if not result.has("first_field_ms"):
			result.first_field_ms = result.parts[part.name].shown_ms
	if Machine.is_drawn():
		_words.text = "Taking pictures …"
		var pictures := Pictures.new()
		result.pictures = await pictures.take(self)
		_save_pictures(pictures.images)
	_end(result)


func _physics_process(delta: float) -> void:
	if _part:
		_part.advance(delta)


func _unhandled_key_input(event: InputEvent) -> void:
	if event.is_pressed() and event.keycode == KEY_ESCAPE:
		get_tree().quit()


func _exit_tree() -> void:
	if Machine.is_drawn():
		DisplayServer.window_set_vsync_mode(_vsync)
	get_viewport().msaa_3d = _msaa


func _begin() -> void:
	if not folder:
		folder = Options.read({"out": FOLDER}).out
	share = share if share > 0.0 else SOFTWARE_SHARE if Machine.is_software() else 1.0
	_msaa = get_viewport().msaa_3d
	get_viewport().msaa_3d = Viewport.MSAA_2X
	if Machine.is_drawn():
		_vsync = DisplayServer.window_get_vsync_mode()
		DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)


func _measure(part: Dictionary) -> Dictionary:
	var begun := Time.get_ticks_msec()
	_part = Parts.new()
	_part.begin(self, $Camera, part, share)
	while _part.field.get_statistics().waiting and _since(begun) < COMPILING:
		await get_tree().process_frame
	var shown := Time.get_ticks_msec() - begun
	while _part.field.get_statistics().compiling > 0 and _since(begun) < COMPILING:
		await get_tree().process_frame
	var ready_ms := Time.get_ticks_msec() - begun
	var meter := Meter.new(get_viewport())
	var start := Time.get_ticks_msec()
	while _since(start) < part.seconds * share:
		await get_tree().process_frame
		meter.look(_part.field)
	var result := meter.result(_part.field)
	result.merge({shown_ms = shown, ready_ms = ready_ms, backend = _part.field.get_statistics().backend})
	_part.end()
	_part = null
	await get_tree().process_frame
	return result


static func _since(begun: int) -> float:
	return (Time.get_ticks_msec() - begun) * 1e-3


func _save_pictures(images: Dictionary[String, Image]) -> void:
	DirAccess.make_dir_recursive_absolute(folder)
	for picture in images:
		images[picture].save_png(folder.path_join(picture + ".png"))


func _end(result: Dictionary) -> void:
	var text := Report.text(result)
	var place := Report.write(folder, result, text)
	if Machine.is_drawn():
		DisplayServer.clipboard_set(text)
	print(text)
	_words.text = "%s\n\nThis text is in the clipboard, and with the pictures in\n%s\nEsc ends the program." % [text, place]
	ended.emit(result)
	if Options.all().has("out"):
		get_tree().quit()
