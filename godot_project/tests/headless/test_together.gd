# SPDX-License-Identifier: MIT
## A server sends a client, in a process of its own and over the loopback address, what was cut, worn and painted.
extends "res://tests/field_case.gd"

const PLACE := Vector2(0.25, 0.25)

var _port: PacketPeerStream
var _connection: StreamPeerTCP
var _client := {}  # its pipes: who prints into one that is closed is killed
var _pid := -1


## Starts the second process and waits until it has called.
func call_client() -> bool:
	var server := TCPServer.new()
	if not assert_eq(server.listen(0, "127.0.0.1"), OK, "no port on the loopback address"):
		return false
	var arguments: Array[String] = ["--headless", "--path", ProjectSettings.globalize_path("res://")]
	arguments.append_array(["--script", "res://tests/fixtures/together_client.gd", "--", str(server.get_local_port())])
	_client = OS.execute_with_pipe(OS.get_executable_path(), arguments)
	if not assert_false(_client.is_empty(), "no second process"):
		return false
	_pid = _client.pid
	await wait_until(func() -> bool: return server.is_connection_available() or not OS.is_process_running(_pid), "the client calls")
	_connection = server.take_connection()
	server.stop()
	if not assert_true(_connection != null, "the client ended before it called"):
		return false
	_port = PacketPeerStream.new()
	_port.output_buffer_max_size = 1 << 22
	_port.stream_peer = _connection
	return true


## Returns what the client answers: {ok, hash of its map, cut and wear at PLACE}.
func tell(message: Dictionary) -> Dictionary:
	_port.put_var(message)
	var answered := func() -> bool:
		_connection.poll()
		return _port.get_available_packet_count() > 0 or not OS.is_process_running(_pid)
	await wait_until(answered, "the client answers")
	return _port.get_var() if _port.get_available_packet_count() > 0 else {}


func answer_to(map: GrassMap, is_ok := true) -> Dictionary:
	return {
		ok = is_ok,
		hash = hash(map.data),
		cut = map.sample(GrassMap.CHANNEL_CUT, PLACE),
		wear = map.sample(GrassMap.CHANNEL_WEAR, PLACE),
	}


func test_a_client_follows_its_server() -> void:
	if not await call_client():
		return
	var field := add_field({size = Vector2(16, 16), map = full_map()})
	var map := field.map
	field.paint(brush(GrassBrush.TOOL_ERASE, 1.0), Vector3(-3, 0, 0), Vector3(3, 0, 0))
	await ticks(1)
	assert_eq(await tell({data = map.data}), answer_to(map), "all of it")
	var sent := map.take_snapshot()
	var diffs: Array[PackedByteArray] = []
	for step in 6:
		match step % 3:
			0:
				field.cut(ball(1.0), Transform3D(Basis(), Vector3(step, 0.1, 0)))
			1:
				field.trample(Vector3(0.1 * step, 0, 0.25), 1.0, 0.2)
			2:
				field.paint(brush(GrassBrush.TOOL_COMB, 1.0), Vector3(-step, 0, 2), Vector3(step, 0, 2))
		diffs.append(map.get_changes_since(sent))
		sent = map.take_snapshot()
		assert_less(diffs[-1].size(), map.data.size() + 100, "no larger than the map")
		if step < 3:
			assert_eq(await tell({changes = diffs[-1]}), answer_to(map), "change %d" % step)
	assert_less(map.sample(GrassMap.CHANNEL_CUT, PLACE), 0.5, "it was cut")
	assert_greater(map.sample(GrassMap.CHANNEL_WEAR, PLACE), 0.1, "and worn")
	assert_true(map.get_changes_since(sent).is_empty(), "nothing since")
	# The last three: twice, broken, and again.
	assert_true((await tell({changes = diffs[2]})).ok, "what came before does nothing")
	assert_false((await tell({changes = diffs[3].slice(0, -1)})).ok, "cut off")
	for i in 3:
		var is_last := i == 2
		var answer := await tell({changes = diffs[3 + i]})
		assert_true(answer.ok, "change %d" % (3 + i))
		if is_last:
			assert_eq(answer, answer_to(map), "all is there")
	await tell({})
	await wait_until(func() -> bool: return not OS.is_process_running(_pid), "the client ends by itself")
	assert_eq(OS.get_process_exit_code(_pid), 0)


func test_changes_that_do_not_fit_are_refused_by_name() -> void:
	var server := full_map()
	var client := full_map()
	var states := [server.take_snapshot()]
	for radius: float in [1.0, 2.0]:
		server.stroke(brush(GrassBrush.TOOL_CUT, radius), Vector2.ZERO, Vector2(1, 0))
		states.append(server.take_snapshot())
	var two := server.get_changes_since(states[1])
	var both := server.get_changes_since(states[0])
	var told := []
	client.chunks_changed.connect(func(chunks: Array[Vector2i], _region: Rect2) -> void: told.append(chunks))
	expect_error("these changes begin with another state of the cut of chunk")
	assert_false(client.apply_changes(two), "the first is missing")
	expect_error("these changes are damaged or cut off")
	assert_false(client.apply_changes(both.slice(0, both.size() / 2)))
	expect_error("these changes are not changes of a grass map")
	assert_false(client.apply_changes(server.data))
	assert_true(client.is_empty() and told.is_empty(), "nothing happened to it")
	assert_true(client.apply_changes(PackedByteArray()), "nothing changed")
	assert_true(client.apply_changes(both))
	assert_eq(client.data, server.data)
	assert_eq(told, [server.get_chunks()])
	assert_true(client.apply_changes(both), "again")
	assert_eq(told.size(), 1)
	expect_error("get_changes_since() needs a snapshot from take_snapshot()")
	assert_true(client.get_changes_since(null).is_empty())


## A field shows what its map was told.
func test_a_field_grows_what_its_map_is_told() -> void:
	var server := full_map()
	var field := add_field({map = full_map()})
	var before := server.take_snapshot()
	await grown(field)
	assert_greater(field.get_density_at(Vector3.ZERO), 0.9)
	server.stroke(brush(GrassBrush.TOOL_ERASE, 1.0), Vector2.ZERO, Vector2.ZERO)
	assert_true(field.map.apply_changes(server.get_changes_since(before)))
	await grown(field)
	assert_eq(field.get_density_at(Vector3.ZERO), 0.0)
	before = server.take_snapshot()
	server.base_density = 0.0
	assert_true(field.map.apply_changes(server.get_changes_since(before)))
	assert_eq(field.map.base_density, 0.0)
