# SPDX-License-Identifier: MIT
## Channels of a GrassMap as images, PNG and EXR, out and in again; pictures that do not fit.
extends "res://tests/case.gd"

const FOLDER := "user://map_pictures/"
const REGION := Rect2(-10, -20, 37, 41)


func before() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)


func after() -> void:
	remove_folder(FOLDER)


func channels() -> Array:
	return range(ClassDB.class_get_enum_constants("GrassMap", "Channel").size())


func is_in_metres(channel: int) -> bool:
	return channel == GrassMap.CHANNEL_GROUND


## Returns a map with something in every channel, over several chunks.
func painted_map() -> GrassMap:
	var map := GrassMap.new()
	map.base_density = 0.25
	seed(7)
	for channel: int in channels():
		var image := map.get_channel_image(channel, REGION, true)
		for n in 300:
			var at := Vector2i(randi() % image.get_width(), randi() % image.get_height())
			var whole := channel in [GrassMap.CHANNEL_SPECIES, GrassMap.CHANNEL_LEDGE]
			var value := float(randi() % 16) if whole else randf()
			var color := Color(value, value, value, 1.0)
			if image.get_format() in [Image.FORMAT_RGBF, Image.FORMAT_RGBAF]:
				color = Color(randf(), randf(), randf(), randf() if image.get_format() == Image.FORMAT_RGBAF else 1.0)
			image.set_pixelv(at, color)
		if is_in_metres(channel):
			image.set_pixel(3, 3, Color(-16384.0 + 1.0 / 1024, 0, 0))
			image.set_pixel(4, 3, Color(16384.0 - 1.0 / 1024, 0, 0))
		allow_error("pixels had values outside of what")
		assert_true(map.set_channel_image(channel, image, REGION), str(channel))
	return map


func test_out_and_in_is_the_same_map() -> void:
	var map := painted_map()
	var data := map.data
	var chunks := map.get_chunks()
	var changes := []
	map.chunks_changed.connect(func(changed: Array[Vector2i], _region: Rect2) -> void: changes.append(changed))
	for region: Rect2 in [Rect2(), Rect2(-128, -128, 256, 256), Rect2(-7.5, -3, 20.5, 31)]:
		for channel: int in channels():
			for extension: String in ["exr"] if is_in_metres(channel) else ["png", "exr"]:
				var path := FOLDER + "channel." + extension
				var text := "%d %s %s" % [channel, extension, region]
				assert_eq(map.save_channel_image(channel, path, region), OK, text)
				assert_eq(map.load_channel_image(channel, path, region), OK, text)
				assert_eq(map.data, data, text)
	assert_eq(changes, [], "nothing was changed")
	assert_eq(map.get_chunks(), chunks)


func test_pictures_bring_a_whole_map_over() -> void:
	var map := painted_map()
	var other := GrassMap.new()
	other.base_density = map.base_density
	var order := channels()  # what a channel brings with it, such as slopes, the later ones replace
	for channel: int in order:
		var path := FOLDER + "%d.exr" % channel
		assert_eq(map.save_channel_image(channel, path, REGION), OK)
		assert_eq(other.load_channel_image(channel, path, REGION), OK)
	assert_eq(other.data, map.data)


func test_a_mask_becomes_grass_and_undoes() -> void:
	var map := GrassMap.new()
	var mask := Image.create(80, 40, false, Image.FORMAT_L8)
	mask.fill_rect(Rect2i(0, 0, 40, 40), Color.WHITE)
	mask.save_png(FOLDER + "mask.png")
	var before_it := map.take_snapshot()
	assert_eq(map.load_channel_image(GrassMap.CHANNEL_DENSITY, FOLDER + "mask.png", Rect2(-20, -10, 40, 20)), OK)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(-10, 0)), 1.0)
	assert_eq(map.sample(GrassMap.CHANNEL_DENSITY, Vector2(10, 0)), 0.0)
	assert_eq(map.sample(GrassMap.CHANNEL_PAINT, Vector2(-10, 0), 1), 1.0, "rules leave it")
	map.restore_snapshot(before_it)
	assert_true(map.is_empty())
	mask.convert(Image.FORMAT_RH)
	assert_true(map.set_channel_image(GrassMap.CHANNEL_WEAR, mask, Rect2(-20, -10, 40, 20)), "half floats")
	assert_eq(map.sample(GrassMap.CHANNEL_WEAR, Vector2(-10, 0)), 1.0)


## Pictures that do not fit: [image or bytes, file, words of the message].
func test_pictures_that_do_not_fit_are_refused() -> void:
	var map := painted_map()
	map.resource_name = "Meadow"
	var data := map.data
	var grey := Image.create(20, 20, false, Image.FORMAT_L8)
	var colour := Image.create(20, 20, false, Image.FORMAT_RGB8)
	colour.fill(Color.ORANGE)
	var clear := Image.create(20, 20, false, Image.FORMAT_RGBA8)
	var deep := grey.save_png_to_buffer()
	deep[24] = 16
	var gamma := grey.save_png_to_buffer()
	var name_at := gamma.hex_encode().find("sRGB".to_ascii_buffer().hex_encode()) / 2
	if name_at > 0:
		for i in 4:
			gamma[name_at + i] = "sRGX".unicode_at(i)
	var linear := PackedByteArray([0, 0, 0, 4])
	linear.append_array("gAMA".to_ascii_buffer())
	linear.append_array(PackedByteArray([0, 1, 0x86, 0xA0, 0, 0, 0, 0]))
	gamma = gamma.slice(0, 33) + linear + gamma.slice(33)
	var half := grey.save_png_to_buffer().slice(0, 60)
	var half_exr := map.get_channel_image(GrassMap.CHANNEL_HEIGHT, Rect2(0, 0, 20, 20), true).save_exr_to_buffer(true)
	half_exr = half_exr.slice(0, half_exr.size() * 2 / 3)
	for own: String in ["Condition", "Failed to load EXR image", "Invalid/Corrupted data"]:  # of the engine's decoders
		allow_error(own)
	var wrong := [
		[
			"GrassMap 'Meadow': cannot load '%swrong.png': the picture has 20 x 20 pixels, but density has 40 x 40 texels there" % FOLDER,
			GrassMap.CHANNEL_DENSITY,
			grey.save_png_to_buffer()
		],
		["is in colour at pixel (0, 0), but height is one number", GrassMap.CHANNEL_HEIGHT, colour.save_png_to_buffer()],
		["is transparent at pixel (0, 0)", GrassMap.CHANNEL_HEIGHT, clear.save_png_to_buffer()],
		["is grey, but lean has 2 numbers", GrassMap.CHANNEL_LEAN, grey.save_png_to_buffer()],
		["has 8 bits a pixel, but ground is in metres", GrassMap.CHANNEL_GROUND, grey.save_png_to_buffer()],
		["has 16 bits a channel", GrassMap.CHANNEL_HEIGHT, deep],
		["is in a colour space other than sRGB", GrassMap.CHANNEL_HEIGHT, gamma],
		["is neither a PNG nor an EXR", GrassMap.CHANNEL_HEIGHT, grey.save_jpg_to_buffer()],
		["the file is damaged, cut off", GrassMap.CHANNEL_HEIGHT, half],
		["the file is damaged, cut off", GrassMap.CHANNEL_HEIGHT, half_exr],
	]
	for case: Array in wrong:
		var words: String = case[0]
		var file := FileAccess.open(FOLDER + "wrong.png", FileAccess.WRITE)
		file.store_buffer(case[2])
		file.close()
		expect_error(words)
		assert_ne(map.load_channel_image(case[1], FOLDER + "wrong.png", Rect2(0, 0, 20, 20)), OK, words)
		assert_eq(map.data, data, words)
	expect_error("cannot be opened")
	assert_ne(map.load_channel_image(GrassMap.CHANNEL_HEIGHT, FOLDER + "none.png", Rect2(0, 0, 20, 20)), OK)
	expect_error("is saved as .png (8 bit) or .exr (floats)")
	assert_ne(map.save_channel_image(GrassMap.CHANNEL_HEIGHT, FOLDER + "map.jpg"), OK)
	expect_error("ground is in metres, for which the 8 bits of a PNG are too coarse")
	assert_ne(map.save_channel_image(GrassMap.CHANNEL_GROUND, FOLDER + "ground.png"), OK)
	expect_error("must lie within 16,384 m")
	assert_true(map.get_channel_image(GrassMap.CHANNEL_HEIGHT, Rect2(20000, 0, 1, 1)) == null)
	expect_error("height was painted nowhere, so the picture needs a region")
	assert_true(GrassMap.new().get_channel_image(GrassMap.CHANNEL_HEIGHT) == null)
	expect_error("would take 4096 MB of memory, but it may take at most 1024 MB (the project setting grass_field/limits/map_megabytes)")
	assert_true(map.get_channel_image(GrassMap.CHANNEL_LEDGE, Rect2(0, 0, 4096, 4096)) == null)
	expect_error("Decompress it")
	assert_false(map.set_channel_image(GrassMap.CHANNEL_HEIGHT, Image.create(20, 20, false, Image.FORMAT_RGB565), Rect2(0, 0, 20, 20)))
	expect_error("there is no image")
	assert_false(map.set_channel_image(GrassMap.CHANNEL_HEIGHT, null, Rect2(0, 0, 20, 20)))
	expect_error("no such channel")
	assert_true(map.get_channel_image(99, Rect2(0, 0, 20, 20)) == null)
	assert_eq(map.data, data)
	assert_eq(DirAccess.get_files_at(FOLDER), PackedStringArray(["wrong.png"]))


func test_a_map_does_not_grow_past_its_limit() -> void:
	const SETTING := "grass_field/limits/map_megabytes"
	var map := GrassMap.new()
	var mask := Image.create(512, 512, false, Image.FORMAT_L8)
	mask.fill(Color.GRAY)
	assert_true(map.set_channel_image(GrassMap.CHANNEL_WEAR, mask, Rect2(0, 0, 256, 256)))
	var data := map.data
	ProjectSettings.set_setting(SETTING, 1)
	expect_error("would make the map take 2 MB of memory, but it may take at most 1 MB (the project setting %s)" % SETTING)
	var is_set := map.set_channel_image(GrassMap.CHANNEL_DENSITY, mask, Rect2(0, 0, 256, 256))
	ProjectSettings.set_setting(SETTING, ProjectSettings.property_get_revert(SETTING))
	assert_false(is_set)
	assert_eq(map.data, data)
