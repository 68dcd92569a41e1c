# A world for tp100d and tp100-sim: answers world/1 (daemon/worlds/WORLD.md) from the engine's scene.
# The course, the robot and the options come as JSON in the environment; scripts/godot sets it.
extends Spatial

const Frame = preload("res://frame.gd")
const Terrain = preload("res://terrain.gd")
const TrackedBody = preload("res://tracked_body.gd")
const View = preload("res://view.gd")
const Hand = preload("res://hand.gd")

const MOST_BYTES := 1200
const MOST_TICKS := 250  # of physics between two poses: half a second

var udp := PacketPeerUDP.new()
var settings := {}
var shape := {}
var frame := Frame.new()
var terrain: Spatial
var body: RigidBody
var view: Node
var hand: Node

var session := -1
var owner_of_pose := false
var seq := 0
var run := -1
var last_timestamp_s := 0.0
var pending := {}      # the pose that the physics works on
var ticks_left := 0
var stopped := false   # STOP was pressed here
var at := Transform()  # the robot as last answered

func _ready() -> void:
	var parsed := JSON.parse(OS.get_environment("TP100_WORLD"))
	if parsed.error != OK or typeof(parsed.result) != TYPE_DICTIONARY:
		fail("TP100_WORLD: no course; start this project with scripts/godot")
		return
	settings = parsed.result
	shape = settings.robot.get("shape", {})
	terrain = Terrain.new()
	add_child(terrain)
	terrain.build(settings.course, shape)
	PhysicsServer.set_active(false)
	if OS.get_name() != "Server":
		view = View.new()
		add_child(view)
		view.build(settings)
		hand = Hand.new()
		add_child(hand)
		hand.build(view, terrain)
	if not open_port():
		return
	print("listening at %s:%d" % [settings.host, settings.port])

func fail(text: String) -> void:
	printerr(text)
	get_tree().quit(2)
	set_physics_process(false)

func open_port() -> bool:
	if settings.port != 0:
		if udp.listen(int(settings.port), settings.host, 65536) == OK:
			return true
		fail("%s:%d: the port is taken; use --listen 127.0.0.1:0" % [settings.host, settings.port])
		return false
	randomize()
	for _try in 100:
		settings.port = 20000 + randi() % 12000
		if udp.listen(settings.port, settings.host, 65536) == OK:
			return true
	fail("%s: no free port from 20000 to 32000; give one with --listen" % settings.host)
	return false

# In a window each turn of the engine looks for datagrams; otherwise it waits for one. Physics ticks only while a
# pose's time has to pass: the engine's time is that of the poses.
func _physics_process(_delta: float) -> void:
	if view != null:
		view.turn()
	if not pending.empty():
		if ticks_left > 0:
			ticks_left -= 1
			return
		PhysicsServer.set_active(false)
		answer_by_body(pending)
		pending = {}
	var waits: bool = view == null or not view.film.empty()
	while pending.empty():
		if view != null and view.image_due:
			return
		if udp.get_available_packet_count() == 0:
			if not waits:
				OS.delay_usec(500)
				return
			udp.wait()
		var datagram := udp.get_packet()
		if datagram.size() > 0 and datagram.size() <= MOST_BYTES:
			receive(datagram.get_string_from_utf8())

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
	PhysicsServer.set_active(false)
	if owner_of_pose and body == null:
		body = TrackedBody.new()
		add_child(body)
		body.build(shape, settings.robot.get("emulated", {}).get("body", {}))
	if hand != null:
		hand.body = body if owner_of_pose else null
	send({"v": 1, "type": "welcome", "session": session, "name": "sim/godot", "frame": frame.name,
			"authority": "world" if owner_of_pose else "bridge"})

func pose(message: Dictionary) -> void:
	if int(message.session) != session:
		return
	if owner_of_pose:
		start_ticks(message)
	else:
		answer_by_rays(message)

# The bridge's place; height, tilt and contact by rays and shapes.
func answer_by_rays(message: Dictionary) -> void:
	var space := get_world().direct_space_state
	var p := frame.place_from(message.pos)
	var yaw_rad := frame.yaw_from(message.rpy[2])
	var rest: Dictionary = terrain.stand(space, p[0], p[1], yaw_rad)
	at = Transform(Frame.basis(rest.roll_rad, rest.pitch_rad, yaw_rad), Frame.to_engine(p[0], p[1], rest.z_m))
	answer(message, rest.z_m, [rest.roll_rad, rest.pitch_rad, yaw_rad], rest.surface)

# The engine's physics moves the robot for as long as the bridge's clock went on.
func start_ticks(message: Dictionary) -> void:
	var passed_s: float = message.timestamp - last_timestamp_s
	if int(message.run) != run:
		run = int(message.run)
		var p := frame.place_from(message.pos)
		var yaw_rad := frame.yaw_from(message.rpy[2])
		var rest: Dictionary = terrain.stand(get_world().direct_space_state, p[0], p[1], yaw_rad)
		body.put(p[0], p[1], rest.z_m + 0.0005, Frame.basis(rest.roll_rad, rest.pitch_rad, yaw_rad))
		passed_s = 0.1  # until it rests
	last_timestamp_s = message.timestamp
	var slip = message.get("slip")
	var slips := [0.0, 0.0]
	if typeof(slip) == TYPE_DICTIONARY and Frame.is_number(slip.get("l")) and Frame.is_number(slip.get("r")):
		slips = [clamp(slip.l, -0.5, 0.9), clamp(slip.r, -0.5, 0.9)]
	body.left_mps = clamp(message.tracks.l / frame.length() * (1.0 - slips[0]), -2.0, 2.0)
	body.right_mps = clamp(message.tracks.r / frame.length() * (1.0 - slips[1]), -2.0, 2.0)
	ticks_left = int(clamp(round(passed_s * Engine.iterations_per_second), 1, MOST_TICKS))
	pending = message
	PhysicsServer.set_active(true)

func answer_by_body(message: Dictionary) -> void:
	at = body.reference()
	var rpy := Frame.angles(at.basis)
	var surface: String = terrain.stand(get_world().direct_space_state, -at.origin.z, -at.origin.x, rpy[2]).surface
	answer(message, at.origin.y, rpy, surface)

func answer(message: Dictionary, z_m: float, rpy: Array, surface: String) -> void:
	var touched: Dictionary = terrain.touch(get_world().direct_space_state, at, shape)
	var angles := frame.rpy(rpy[0], rpy[1], rpy[2])
	var ground := {"z": z_m * frame.length(), "pitch": angles[1], "roll": angles[0]}
	if not surface.empty():
		ground.surface = surface
	seq += 1
	var out := {"v": 1, "type": "world", "session": session, "seq": seq, "ack": int(message.seq), "ground": ground,
			"contact": {"step": touched.step_m * frame.length(), "blocked": touched.blocked},
			"cmd": {"estop": stopped}}
	if owner_of_pose:
		out.pose = {"pos": frame.place(-at.origin.z, -at.origin.x, z_m), "rpy": angles}
	send(out)
	if view != null:
		view.robot_at(at, message, frame)
		hand.robot_at(at)

# Space presses STOP; it stays pressed until R.
func _unhandled_key_input(event: InputEventKey) -> void:
	if event.pressed and event.scancode == KEY_SPACE:
		stopped = true
		print("STOP: pressed; R releases it")
	elif event.pressed and event.scancode == KEY_R:
		stopped = false
		print("STOP: released")
