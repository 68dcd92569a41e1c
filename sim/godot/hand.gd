# The user's hand: a click on the floor adds an obstacle there or removes it; dragging the robot pushes it.
# A robot can be pushed only if the world owns its pose; otherwise the bridge decides where it is.
extends Node

const OBSTACLE_M := Vector3(0.1, 0.08, 0.1)
const REACH_M := 0.12     # a press within this distance of the robot's middle grabs it
const STIFFNESS_NPM := 40.0
const MOST_N := 4.0       # less than the tracks' traction: it can be held back but not carried away

var camera: Camera
var robots := []
var obstacles = []        # each is an array of bodies, one in each robot's space
var held: Node            # a robot, or null
var target := Vector3()   # where the hand is, while it holds the robot

func build(of_view: Spatial, of_robots: Array) -> void:
	camera = of_view.camera
	robots = of_robots
	for robot in robots:
		robot.connect("moved", self, "push", [robot])

# The point of the floor under the mouse.
func floor_at(mouse: Vector2):
	return Plane(Vector3.UP, 0.0).intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))

# Pulls a held robot towards the hand like a spring.
func push(at: Transform, _message: Dictionary, _frame: Reference, robot: Node) -> void:
	if not robot.owner_of_pose:
		return
	var apart := target - at.origin
	apart.y = 0.0
	robot.body.push_n = apart.normalized() * min(apart.length() * STIFFNESS_NPM, MOST_N) if held == robot else Vector3()

func flat_distance(a: Vector3, b: Vector3) -> float:
	return Vector2(a.x - b.x, a.z - b.z).length()

func click(point: Vector3) -> void:
	for obstacle in obstacles:
		var local: Vector3 = obstacle[0].transform.origin
		if abs(local.x - point.x) <= OBSTACLE_M.x / 2 and abs(local.z - point.z) <= OBSTACLE_M.z / 2:
			obstacles.erase(obstacle)
			for body in obstacle:
				body.queue_free()
			print("obstacle: taken away")
			return
	var bodies := []
	for robot in robots:
		bodies.append(robot.terrain.add_obstacle(Transform(Basis(), point), OBSTACLE_M, bodies.empty()))
	obstacles.append(bodies)
	print("obstacle: %.3f m forward, %.3f m to the left" % [-point.z, -point.x])

func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventMouseButton and event.button_index == BUTTON_LEFT:
		var point = floor_at(event.position)
		if not event.pressed:
			held = null
			return
		if point == null:
			return
		for robot in robots:
			if flat_distance(point, robot.at.origin) <= REACH_M:
				held = robot
				target = point
				print("robot: held")
				return
		click(point)
	elif event is InputEventMouseMotion and held != null:
		var point = floor_at(event.position)
		if point != null:
			target = point
