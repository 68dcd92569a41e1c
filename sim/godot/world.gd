# A scene with one or more robots. Each has a bridge of its own, tp100d or tp100-sim (robot.gd).
# scripts/godot passes the course, the robots and the options as JSON in the environment.
extends Spatial

const Robot = preload("res://robot.gd")
const View = preload("res://view.gd")

var robots := []
var obstacles := {}      # by robot: its obstacles in the spaces of the others
var view: Node
var stopped := false     # STOP was pressed here

func _ready() -> void:
	var parsed := JSON.parse(OS.get_environment("TP100_WORLD"))
	if parsed.error != OK or typeof(parsed.result) != TYPE_DICTIONARY:
		fail("TP100_WORLD: no course; start this project with scripts/godot")
		return
	var settings: Dictionary = parsed.result
	randomize()
	if OS.get_name() != "Server":
		view = View.new()
		add_child(view)
		view.build(settings)
	for file in settings.robots:
		var robot := Robot.new()
		robot.world = self
		add_child(robot)
		robot.build(settings.course, file, get_world().space, not robots.empty())
		robot.connect("moved", self, "stand_in_the_way", [robot])
		robots.append(robot)
		obstacles[robot] = []
	if view != null:
		view.robots_are(robots)
	for i in robots.size():
		var wanted: int = settings.port + i if settings.port != 0 else 0
		var port: int = robots[i].open_port(settings.host, wanted)
		if port == 0:
			fail("%s:%d: the port is taken; use --listen 127.0.0.1:0" % [settings.host, wanted])
			return
		print("listening at %s:%d" % [settings.host, port])

func fail(text: String) -> void:
	printerr(text)
	get_tree().quit(2)
	set_physics_process(false)

# With a window, each engine iteration polls for datagrams; otherwise it waits for one. Physics ticks only while a pose
# is pending: the engine's time is that of the poses.
func _physics_process(_delta: float) -> void:
	if view != null:
		view.turn()
	for robot in robots:
		robot.tick()
	var waits: bool = view == null or not view.film.empty()
	while true:
		if view != null and view.image_due:
			return
		var heard := false
		var ticks := false
		for robot in robots:
			heard = robot.hear() or heard
			ticks = ticks or not robot.pending.empty()
		if ticks:
			return
		if not heard:
			if not waits:
				OS.delay_usec(500)
				return
			if robots.size() == 1:
				robots[0].udp.wait()
			else:
				OS.delay_usec(200)

# A robot stays an obstacle where it was last, also after its bridge has ended. Before its first run it is nowhere.
func stand_in_the_way(at: Transform, message: Dictionary, _frame: Reference, robot: Node) -> void:
	if int(message.run) == 0:
		return
	for obstacle in obstacles[robot]:
		obstacle.free()
	obstacles[robot] = []
	for other in robots:
		if other != robot:
			obstacles[robot].append(other.terrain.add_obstacle(at, robot.hull_m()))

# Space presses STOP; it stays pressed until R.
func _unhandled_key_input(event: InputEventKey) -> void:
	if event.pressed and event.scancode == KEY_SPACE:
		stopped = true
		print("STOP: pressed; R releases it")
	elif event.pressed and event.scancode == KEY_R:
		stopped = false
		print("STOP: released")
