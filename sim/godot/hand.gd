# The person's hand: a click on the floor puts an obstacle there or takes it away; dragging the robot pushes it.
# Only a world that owns the pose can be pushed: otherwise the bridge says where the robot is.
extends Node

const OBSTACLE_M := Vector3(0.1, 0.08, 0.1)
const REACH_M := 0.12     # a press so near to the robot's middle takes hold of it
const STIFFNESS_NPM := 40.0
const MOST_N := 4.0       # less than the tracks' traction: it can be held back, not carried off

var camera: Camera
var robots := []
var obstacles = []        # each as one body for each robot's space
var held: Node            # a robot, or null
var target := Vector3()   # where the hand is, while it holds the robot

func build(of_view: Spatial, of_robots: Array) -> void:
	camera = of_view.camera
	robots = of_robots
	for robot in robots:
		robot.connect("moved", self, "push", [robot])

# Where the mouse points at the floor.
func floor_at(mouse: Vector2):
	return Plane(Vector3.UP, 0.0).intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))

# A spring from the robot to the hand.
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
