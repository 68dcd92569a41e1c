# A scene with a robot, whose bridge is tp100d or tp100-sim (robot.gd).
# scripts/godot passes the course, the robot and the options as JSON in the environment.
extends Spatial

const Robot = preload("res://robot.gd")
const View = preload("res://view.gd")

var robot := Robot.new()
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
	robot.world = self
	add_child(robot)
	robot.build(settings.course, settings.robot, get_world().space)
	if view != null:
		robot.connect("moved", view, "robot_at")
	var port: int = robot.open_port(settings.host, settings.port)
	if port == 0:
		fail("%s:%d: the port is taken; use --listen 127.0.0.1:0" % [settings.host, settings.port])
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
	robot.tick()
	while robot.pending.empty():
		if view != null and view.image_due:
			return
		if robot.hear():
			continue
		if view != null and view.film.empty():
			OS.delay_usec(500)
			return
		robot.udp.wait()

# Space presses STOP; it stays pressed until R.
func _unhandled_key_input(event: InputEventKey) -> void:
	if event.pressed and event.scancode == KEY_SPACE:
		stopped = true
		print("STOP: pressed; R releases it")
	elif event.pressed and event.scancode == KEY_R:
		stopped = false
		print("STOP: released")
