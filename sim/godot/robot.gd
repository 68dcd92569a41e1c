# The robot: speaks world/1 (daemon/worlds/WORLD.md) with its bridge, and stands or moves in the scene's physics space,
# whose time is that of the bridge's poses.
extends Node

const Frame = preload("res://frame.gd")
const Terrain = preload("res://terrain.gd")
const TrackedBody = preload("res://tracked_body.gd")

const MOST_BYTES := 1200
const MOST_TICKS := 250   # physics ticks between two poses: half a second

# The robot's transform in the answer to `message`.
signal moved(at, message, frame)

var udp := PacketPeerUDP.new()
var file := {}            # the robot file
var shape := {}
var frame := Frame.new()
var space: RID
var terrain: Spatial
var body: RigidBody
var world: Node           # has the property `stopped`

var session := -1
var owner_of_pose := false
var seq := 0
var run := -1
var last_timestamp_s := 0.0
var pending := {}         # the pose message for which physics runs
var ticks_left := 0
var at := Transform()     # the robot in the last answer

func build(course: Dictionary, robot: Dictionary, scene_space: RID) -> void:
	file = robot
	shape = robot.get("shape", {})
	space = scene_space
	PhysicsServer.space_set_active(space, false)
	terrain = Terrain.new()
	add_child(terrain)
	terrain.build(course, shape, space)

# Returns the port, or 0 if none is free.
func open_port(host: String, port: int) -> int:
	if port != 0:
		return port if udp.listen(port, host, 65536) == OK else 0
	for _try in 100:
		var tried := 20000 + randi() % 12000
		if udp.listen(tried, host, 65536) == OK:
			return tried
	return 0

# Handles one datagram, if there is one and no pose is pending.
func hear() -> bool:
	if not pending.empty() or udp.get_available_packet_count() == 0:
		return false
	var datagram := udp.get_packet()
	if datagram.size() > 0 and datagram.size() <= MOST_BYTES:
		receive(datagram.get_string_from_utf8())
	return true

# Call once per physics tick: this robot's time advances only while a pose is pending.
func tick() -> void:
	if pending.empty():
		return
	if ticks_left > 0:
		ticks_left -= 1
		return
	PhysicsServer.space_set_active(space, false)
	answer_by_body(pending)
	pending = {}

func receive(text: String) -> void:
	if text.empty():
		return
	var parsed := JSON.parse(text)
	var message = parsed.result
	if parsed.error != OK or typeof(message) != TYPE_DICTIONARY:
		printerr("world: a datagram is not JSON; dropped")
		return
	udp.set_dest_address(udp.get_packet_ip(), udp.get_packet_port())
	if not Frame.is_number(message.get("v")) or message.v != 1:
		send({"v": 1, "type": "error", "text": "this is world/1"})
		return
	match message.get("type"):
		"hello":
			hello(message)
		"pose":
			if has_pose(message):
				pose(message)
			else:
				printerr("world: a pose lacks a field or has one of another type; dropped")
		"error":
			printerr("world: the bridge answers: ", str(message.get("text")).left(200))

func send(message: Dictionary) -> void:
	udp.put_packet(JSON.print(message).to_utf8())

static func has_pose(message: Dictionary) -> bool:
	var tracks = message.get("tracks")
	return (Frame.is_number(message.get("session")) and Frame.is_number(message.get("seq")) and Frame.is_number(message.get("run"))
			and Frame.is_number(message.get("timestamp")) and Frame.are_numbers(message.get("pos"), 3)
			and Frame.are_numbers(message.get("rpy"), 3) and Frame.is_floor_pose(message.get("floor"))
			and typeof(tracks) == TYPE_DICTIONARY and Frame.is_number(tracks.get("l")) and Frame.is_number(tracks.get("r")))

func hello(message: Dictionary) -> void:
	if not Frame.is_number(message.get("session")) or not message.get("frame") in Frame.NAMES:
		printerr("world: a hello lacks its session or has an unknown frame; dropped")
		return
	session = int(message.session)
	owner_of_pose = message.get("authority") == "world"
	frame = Frame.new(message.frame)
	seq = 0
	run = -1
	pending = {}
	PhysicsServer.space_set_active(space, false)
	if owner_of_pose and body == null:
		body = TrackedBody.new()
		add_child(body)
		PhysicsServer.body_set_space(body.get_rid(), space)
		body.build(shape, file.get("emulated", {}).get("body", {}))
	send({"v": 1, "type": "welcome", "session": session, "name": "sim/godot", "frame": frame.name,
			"authority": "world" if owner_of_pose else "bridge"})

func pose(message: Dictionary) -> void:
	if int(message.session) != session:
		return
	if owner_of_pose:
		start_ticks(message)
	else:
		answer_by_rays(message)

# Answers with the bridge's position; height, tilt and contact come from rays and shapes.
func answer_by_rays(message: Dictionary) -> void:
	var p := frame.place_from(message.pos)
	var yaw_rad := frame.yaw_from(message.rpy[2])
	var rest: Dictionary = terrain.stand(p[0], p[1], yaw_rad)
	at = Transform(Frame.basis(rest.roll_rad, rest.pitch_rad, yaw_rad), Frame.to_engine(p[0], p[1], rest.z_m))
	answer(message, rest.z_m, [rest.roll_rad, rest.pitch_rad, yaw_rad], rest.surface)

# Lets the engine's physics move the robot for the time that passed on the bridge's clock.
func start_ticks(message: Dictionary) -> void:
	var passed_s: float = message.timestamp - last_timestamp_s
	if int(message.run) != run:
		run = int(message.run)
		var p := frame.place_from(message.pos)
		var yaw_rad := frame.yaw_from(message.rpy[2])
		var rest: Dictionary = terrain.stand(p[0], p[1], yaw_rad)
		body.put(p[0], p[1], rest.z_m + 0.0005, Frame.basis(rest.roll_rad, rest.pitch_rad, yaw_rad))
		passed_s = 0.1  # until it has settled
	last_timestamp_s = message.timestamp
	var slip = message.get("slip")
	var slips := [0.0, 0.0]
	if typeof(slip) == TYPE_DICTIONARY and Frame.is_number(slip.get("l")) and Frame.is_number(slip.get("r")):
		slips = [clamp(slip.l, -0.5, 0.9), clamp(slip.r, -0.5, 0.9)]
	body.left_mps = clamp(message.tracks.l / frame.length() * (1.0 - slips[0]), -2.0, 2.0)
	body.right_mps = clamp(message.tracks.r / frame.length() * (1.0 - slips[1]), -2.0, 2.0)
	# Less one: the first tick passes before the next call of tick().
	ticks_left = int(clamp(round(passed_s * Engine.iterations_per_second), 1, MOST_TICKS)) - 1
	pending = message
	PhysicsServer.space_set_active(space, true)

func answer_by_body(message: Dictionary) -> void:
	at = body.reference()
	var rpy := Frame.angles(at.basis)
	var surface: String = terrain.stand(-at.origin.z, -at.origin.x, rpy[2]).surface
	answer(message, at.origin.y, rpy, surface)

func answer(message: Dictionary, z_m: float, rpy: Array, surface: String) -> void:
	var touched: Dictionary = terrain.touch(at)
	var angles := frame.rpy(rpy[0], rpy[1], rpy[2])
	var ground := {"z": z_m * frame.length(), "pitch": angles[1], "roll": angles[0]}
	if not surface.empty():
		ground.surface = surface
	seq += 1
	var out := {"v": 1, "type": "world", "session": session, "seq": seq, "ack": int(message.seq), "ground": ground,
			"contact": {"step": touched.step_m * frame.length(), "blocked": touched.blocked},
			"cmd": {"estop": world.stopped}}
	if owner_of_pose:
		out.pose = {"pos": frame.place(-at.origin.z, -at.origin.x, z_m), "rpy": angles}
	send(out)
	emit_signal("moved", at, message, frame)
