# SPDX-License-Identifier: MIT
## Two people paint one map: GrassMap.merge(), the tool on the command line, and git that calls it.
extends "res://tests/case.gd"

const FOLDER := "user://map_merge"
const TOOL := "res://addons/grass_field/tools/merge_maps.gd"


func before() -> void:
	after()
	DirAccess.make_dir_recursive_absolute(FOLDER)


func after() -> void:
	if DirAccess.dir_exists_absolute(FOLDER):
		_remove(FOLDER)


func _remove(folder: String) -> void:
	var directory := DirAccess.open(folder)
	directory.include_hidden = true
	for file in directory.get_files():
		DirAccess.remove_absolute(folder.path_join(file))
	for inner in directory.get_directories():
		_remove(folder.path_join(inner))
	DirAccess.remove_absolute(folder)


func brush(tool: GrassBrush.Tool) -> GrassBrush:
	var made := GrassBrush.new()
	made.tool = tool
	made.radius = 3.0
	made.strength = 1.0
	return made


## Returns the map with one more stroke.
func painted(map: GrassMap, tool: GrassBrush.Tool, x: float) -> GrassMap:
	var copy: GrassMap = map.duplicate()
	copy.stroke(brush(tool), Vector2(x, 0), Vector2(x, 5))
	return copy


func file(name: String, map: GrassMap = null) -> String:
	var path := ProjectSettings.globalize_path(FOLDER.path_join(name))
	if map:
		assert_eq(map.save_to_file(path), OK)
	return path


func run_tool(arguments: Array) -> Array:
	var output := []
	var line := ["--headless", "--path", ProjectSettings.globalize_path("res://"), "--script", TOOL, "--"] + arguments
	var code := OS.execute(OS.get_executable_path(), PackedStringArray(line), output, true)
	return [code, output[0]]


func test_maps_merge_and_the_report_names_conflicts() -> void:
	var base := painted(GrassMap.new(), GrassBrush.TOOL_PAINT, 0.0)
	var mine := painted(base, GrassBrush.TOOL_PAINT, 20.0)
	var theirs := painted(base, GrassBrush.TOOL_TINT, 0.0)
	var told := []
	mine.chunks_changed.connect(func(chunks: Array[Vector2i], _region: Rect2) -> void: told.append(chunks))
	var both := painted(mine, GrassBrush.TOOL_TINT, 0.0)
	var before_it := mine.take_snapshot()
	var report := mine.merge(base, theirs)
	assert_greater(report.texels, 20)
	assert_eq(report.conflicts, [])
	assert_false(report.base_density_conflict)
	assert_eq(mine.data, both.data)
	assert_eq(told.size(), 1)
	mine.restore_snapshot(before_it)
	mine.stroke(brush(GrassBrush.TOOL_CUT), Vector2(32, 32), Vector2(32, 32))
	theirs.stroke(brush(GrassBrush.TOOL_CUT), Vector2(33, 32), Vector2(33, 32))
	assert_eq(mine.merge(base, theirs).conflicts, [], "both cut to the same height")
	var lower := brush(GrassBrush.TOOL_CUT)
	lower.cut_height = 0.02
	theirs.stroke(lower, Vector2(33, 32), Vector2(33, 32))
	var conflicts: Array = mine.merge(base, theirs).conflicts
	assert_eq(conflicts.map(func(conflict: Dictionary) -> int: return conflict.channel), [GrassMap.CHANNEL_CUT])
	assert_true(Rect2(29, 29, 7, 6).encloses(conflicts[0].region), "around both")
	assert_greater(conflicts[0].texels, 20)
	expect_error("merge() needs two maps")
	assert_eq(mine.merge(null, theirs), {})


func test_the_tool_merges_files_and_its_exit_code_tells() -> void:
	var base := painted(GrassMap.new(), GrassBrush.TOOL_PAINT, 0.0)
	var mine := painted(base, GrassBrush.TOOL_PAINT, 20.0)
	var theirs := painted(base, GrassBrush.TOOL_TINT, 0.0)
	var files := [file("base", base), file("mine", mine), file("theirs", theirs)]
	var clean := run_tool(files + ["--output=" + file("merged")])
	assert_eq(clean[0], 0, clean[1])
	assert_eq(GrassMap.load_from_file(file("merged")).data, painted(mine, GrassBrush.TOOL_TINT, 0.0).data)
	assert_eq(GrassMap.load_from_file(file("mine")).data, mine.data, "as it was")
	var shorter := brush(GrassBrush.TOOL_HEIGHT)
	shorter.target = 0.2
	theirs.stroke(shorter, Vector2.ZERO, Vector2.ZERO)
	var half := brush(GrassBrush.TOOL_HEIGHT)
	half.target = 0.5
	mine.stroke(half, Vector2.ZERO, Vector2.ZERO)
	file("mine", mine)
	file("theirs", theirs)
	var conflict := run_tool(files + ["levels/meadow.grassmap", "--theirs"])
	assert_eq(conflict[0], 1, conflict[1])
	assert_true("levels/meadow.grassmap: " in conflict[1] and "CONFLICT: height of " in conflict[1], conflict[1])
	assert_near(GrassMap.load_from_file(files[1]).sample(GrassMap.CHANNEL_HEIGHT, Vector2.ZERO), 0.2, 0.01, "theirs")
	var bytes := FileAccess.get_file_as_bytes(files[1])
	FileAccess.open(files[2], FileAccess.WRITE).store_buffer(bytes.slice(0, bytes.size() / 2))
	var broken := run_tool(files)
	assert_eq(broken[0], 2, broken[1])
	assert_true("is cut off" in broken[1], broken[1])
	assert_eq(FileAccess.get_file_as_bytes(files[1]), bytes, "nothing was written")
	assert_eq(run_tool(files.slice(1))[0], 2, "a file is missing")


func test_only_the_base_may_be_empty() -> void:
	var mine := painted(GrassMap.new(), GrassBrush.TOOL_PAINT, 0.0)
	var files := [file("base", mine), file("mine", mine), file("theirs", mine)]
	for damaged: String in ["mine", "theirs"]:
		for length: int in [0, 1, 4, mine.data.size() / 2, mine.data.size() - 1]:
			file("mine", mine)
			file("theirs", mine)
			var left := mine.data.slice(0, length)
			FileAccess.open(file(damaged), FileAccess.WRITE).store_buffer(left)
			var result := run_tool(files)
			assert_eq(result[0], 2, "%s with %d bytes: %s" % [damaged, length, result[1]])
			assert_true(damaged in result[1], "names the file: %s" % result[1])
			assert_eq(FileAccess.get_file_as_bytes(file("mine")), left if damaged == "mine" else mine.data, "nothing was written")
	file("mine", mine)
	file("theirs", mine)
	FileAccess.open(file("base"), FileAccess.WRITE).close()
	var added := run_tool(files)
	assert_eq(added[0], 0, "both have added the same map: %s" % added[1])
	assert_eq(GrassMap.load_from_file(file("mine")).data, mine.data)


## Version control and shared disks keep maps behind links.
func test_a_map_behind_a_link_is_written_where_it_is() -> void:
	var first := painted(GrassMap.new(), GrassBrush.TOOL_PAINT, 0.0)
	var second := painted(first, GrassBrush.TOOL_TINT, 0.0)
	DirAccess.make_dir_absolute(FOLDER.path_join("inner"))
	var folder := DirAccess.open(FOLDER)
	for target: String in ["inner/map", file("inner/map")]:  # beside the link, and from the root
		file("inner/map", first)
		assert_eq(folder.create_link(target, "link"), OK)
		assert_eq(folder.create_link("link", "second_link"), OK)
		assert_eq(second.save_to_file(FOLDER.path_join("second_link")), OK)
		assert_true(folder.is_link("link") and folder.is_link("second_link"), "both are links as before")
		assert_eq(GrassMap.load_from_file(file("inner/map")).data, second.data)
		assert_eq(folder.get_files_at(FOLDER.path_join("inner")), PackedStringArray(["map"]), "nothing is left beside it")
		folder.remove("link")
		folder.remove("second_link")
	assert_eq(folder.create_link("there", "back"), OK)
	assert_eq(folder.create_link("back", "there"), OK)
	expect_error("its links lead to each other")
	assert_ne(first.save_to_file(FOLDER.path_join("back")), OK)


## Runs the lines by which the guide configures git, with this engine and this project.
func configure_git() -> void:
	var project := ProjectSettings.globalize_path("res://")
	var commands := "cd '%s'\n" % ProjectSettings.globalize_path(FOLDER)
	var lines := 0
	for line in FileAccess.get_file_as_string(project.path_join("../docs/guide/shared_maps.md")).split("\n"):
		if line.begins_with("git config ") or line.begins_with("echo "):
			lines += 1
			commands += (
				line.replace("godot --headless --path .", "'%s' --headless --path '%s'" % [OS.get_executable_path(), project]) + "\n"
			)
	assert_eq(lines, 3)
	var script := file("configure.sh")  # as arguments, the engine would not quote them
	FileAccess.open(script, FileAccess.WRITE).store_string(commands)
	var output := []
	assert_eq(OS.execute("sh", ["-e", script], output, true), 0, str(output))
	DirAccess.remove_absolute(script)


func git(arguments: Array[String]) -> Array:
	var line: Array[String] = ["-C", ProjectSettings.globalize_path(FOLDER), "-c", "user.name=A", "-c", "user.email=a@example.org"]
	var output := []
	return [OS.execute("git", line + arguments, output, true), output[0]]


func must_git(arguments: Array[String]) -> bool:
	var result := git(arguments)
	return assert_eq(result[0], 0, "git %s: %s" % [" ".join(arguments), result[1]])


func commit(map: GrassMap) -> void:
	file("meadow grass.grassmap", map)
	must_git(["add", "-A"])
	must_git(["commit", "-q", "-m", "painted"])


func test_git_merges_maps() -> void:
	if git(["--version"])[0] != 0:
		skip("no git")
		return
	must_git(["init", "-q", "-b", "main", "."])
	configure_git()
	var base := painted(GrassMap.new(), GrassBrush.TOOL_PAINT, 0.0)
	commit(base)
	must_git(["checkout", "-q", "-b", "theirs"])
	var theirs := painted(base, GrassBrush.TOOL_TINT, 0.0)
	commit(theirs)
	must_git(["checkout", "-q", "main"])
	var mine := painted(base, GrassBrush.TOOL_PAINT, 20.0)
	commit(mine)
	must_git(["merge", "-q", "--no-edit", "theirs"])
	var merged := painted(mine, GrassBrush.TOOL_TINT, 0.0)
	assert_eq(GrassMap.load_from_file(file("meadow grass.grassmap")).data, merged.data, "a clean merge")
	assert_eq(git(["status", "--porcelain"])[1], "", "committed")
	# Now both change the same place.
	must_git(["checkout", "-q", "-b", "higher"])
	commit(painted(merged, GrassBrush.TOOL_CUT, 0.0))
	must_git(["checkout", "-q", "main"])
	var cut := brush(GrassBrush.TOOL_CUT)
	cut.cut_height = 0.3
	merged.stroke(cut, Vector2.ZERO, Vector2.ZERO)
	commit(merged)
	var conflict := git(["merge", "--no-edit", "higher"])
	assert_eq(conflict[0], 1, conflict[1])
	assert_true("CONFLICT: cut of " in conflict[1] and "meadow grass.grassmap" in conflict[1], conflict[1])
	assert_eq((git(["status", "--porcelain"])[1] as String).substr(0, 2), "UU")
	var kept := GrassMap.load_from_file(file("meadow grass.grassmap"))
	assert_near(kept.sample(GrassMap.CHANNEL_CUT, Vector2.ZERO), 0.3, 0.01, "mine stays")
	assert_less(kept.sample(GrassMap.CHANNEL_CUT, Vector2(0, 5)), 0.2, "and theirs, where mine did not change")
