# SPDX-License-Identifier: MIT
## Files of species and patches with anything in them changed, as by a stranger or a faulty disk: what loads has only valid values, and
## takes no more memory and work than any other species. With GRASS_STRESS=full in the environment a field grows from every file, otherwise
## from some of them.
extends "res://tests/fuzz_case.gd"

const FILES := 2000  # of each kind
const FILES_A_FIELD := 100  # of which a field grows from one
const FILE := "user://test_mutated_files.tres"
const ENGINE_MEMORY := 64 << 20  # bytes that loading and showing them may take beyond what the engine took before
const FIELD_MEMORY := 16 << 20  # bytes of a field of 64 tiles with two species, each with its own patch and pictures
const TICKS := 3  # that each species is simulated
const POOL := 16  # tiles
const NUMBERS: Array[String] = ["nan", "inf", "-inf", "-1", "0", "1e308", "-1e30", "1e-320", "65536", "2147483648", "99999999999999999999"]

var number_in_text := RegEx.create_from_string("-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?")


func after() -> void:
	Engine.print_error_messages = true
	if FileAccess.file_exists(FILE):
		DirAccess.remove_absolute(FILE)


## As a file, with every property that has another value than a new one.
func text_of(resource: Resource) -> String:
	rng.seed = 5
	for property in stored(resource):
		if property.type in [TYPE_INT, TYPE_FLOAT, TYPE_COLOR] and not property.name.begins_with("resource_"):
			resource.set(property.name, value_for(property, null))
	ResourceSaver.save(resource, FILE)
	return FileAccess.get_file_as_string(FILE)


func species() -> GrassSpecies:
	var made := GrassSpecies.new()
	made.patch = own_patch()
	made.gradient = Gradient.new()
	made.card = ImageTexture.create_from_image(Image.create(4, 4, true, Image.FORMAT_RGBA8))
	made.leaf = ImageTexture.create_from_image(Image.create(4, 2, false, Image.FORMAT_L8))
	return made


func mutated(text: String) -> PackedByteArray:
	for change_ in rng.randi_range(1, 4):
		var lines := text.split("\n")
		var a := rng.randi_range(0, lines.size() - 1)
		var b := rng.randi_range(0, lines.size() - 1)
		match rng.randi_range(0, 9):
			0:
				text = text.left(rng.randi_range(0, text.length()))
			1:
				lines.remove_at(a)
				text = "\n".join(lines)
			2:
				lines.insert(b, lines[a])
				text = "\n".join(lines)
			3, 4:
				lines[a] = lines[a].get_slice(" = ", 0) + " = " + lines[b].get_slice(" = ", 1)
				text = "\n".join(lines)
			_:
				var numbers := number_in_text.search_all(text)
				if numbers:
					var number := numbers[rng.randi_range(0, numbers.size() - 1)]
					text = text.left(number.get_start()) + NUMBERS[rng.randi_range(0, NUMBERS.size() - 1)] + text.substr(number.get_end())
	var bytes := text.to_utf8_buffer()
	if bytes and rng.randf() < 0.3:
		bytes[rng.randi_range(0, bytes.size() - 1)] = rng.randi_range(0, 255)
	return bytes


func load_bytes(bytes: PackedByteArray) -> Resource:
	var file := FileAccess.open(FILE, FileAccess.WRITE)
	file.store_buffer(bytes)
	file.close()
	return ResourceLoader.load(FILE, "", ResourceLoader.CACHE_MODE_IGNORE)


## Every number lies within the range that its property has in the inspector.
func check_ranges(resource: Resource, what: String) -> void:
	for property in stored(resource):
		if property.hint != PROPERTY_HINT_RANGE:
			continue
		var parts: PackedStringArray = property.hint_string.split(",")
		var value: float = resource.get(property.name)
		var is_allowed := value >= parts[0].to_float() and value <= parts[1].to_float()
		if not is_allowed:
			fail("%s: %s = %s" % [what, property.name, value])


## A field that stands grows from the species beside another one, and bends under a ball.
func grow(field: GrassField, one: GrassSpecies, what: String) -> void:
	var before := field.get_counters()
	field.species = [GrassSpecies.new(), one] as Array[GrassSpecies]
	await grown(field)
	await ticks(TICKS)
	check(field, what)
	var after_ := field.get_counters()
	assert_less(after_.makings - before.makings, 3, what + ": it is made once for the species, and once for a patch that comes later")
	assert_less(field.get_memory_usage(), FIELD_MEMORY, what + ": bytes of the field")


func try_files(text: String, type: String) -> void:
	var field := add_field({pool_tiles = POOL, species = [GrassSpecies.new(), species()] as Array[GrassSpecies]})
	add_held_body(ball(0.2), Vector3(0.2, 0.2, 0.2))
	await grown(field)
	var most := maxi(OS.get_static_memory_peak_usage(), OS.get_static_memory_usage() + ENGINE_MEMORY)
	var steps_before: int = field.get_counters().tile_steps
	var ticks_before := Engine.get_physics_frames()
	var every := 1 if OS.get_environment("GRASS_STRESS") == "full" else FILES_A_FIELD
	rng.seed = 11
	var loaded := 0
	Engine.print_error_messages = false  # what the engine says of broken files fills pages
	for n in FILES:
		var bytes := mutated(text)
		var what := "%s, file %d" % [type, n]
		var found := load_bytes(bytes)
		if not found or not found.is_class(type):
			continue
		loaded += 1
		check_ranges(found, what)
		var grows := found as GrassSpecies
		if found is GrassPatch:
			grows = GrassSpecies.new()
			grows.patch = found
		elif grows.patch:
			check_ranges(grows.patch, what + ", its patch")
		if loaded % every == 0:
			await grow(field, grows, what)
	Engine.print_error_messages = true
	print("    %d of %d files load as %s" % [loaded, FILES, type])
	assert_greater(loaded, FILES / 4, "files that load: else only refusals were looked at")
	assert_less(OS.get_static_memory_peak_usage(), most + 1, "bytes of the engine, at most")
	var steps: int = field.get_counters().tile_steps - steps_before
	assert_less(steps, POOL * (Engine.get_physics_frames() - ticks_before) + 1, "steps of tiles: those of the pool in each tick, at most")


func test_species() -> void:
	await try_files(text_of(species()), "GrassSpecies")


func test_patches() -> void:
	await try_files(text_of(GrassPatch.new()), "GrassPatch")
