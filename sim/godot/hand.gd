# The person's hand: a click on the floor puts an obstacle there or takes it away; dragging the robot pushes it.
# Only a world that owns the pose can be pushed: otherwise the bridge says where the robot is.
extends Node

const OBSTACLE_M := Vector3(0.1, 0.08, 0.1)
const REACH_M := 0.12     # a press so near to the robot's middle takes hold of it
const STIFFNESS_NPM := 40.0
const MOST_N := 4.0       # less than the tracks' grip: it can be held back, not carried off

var camera: Camera
var terrain: Spatial
var body: RigidBody       # null: nothing to push
var robot := Vector3()    # its reference point
var obstacles = []
var held := false
var target := Vector3()   # where the hand is, while it holds the robot

func build(of_view: Spatial, of_terrain: Spatial) -> void:
	camera = of_view.camera
	terrain = of_terrain

# Where the mouse points at the floor.
func floor_at(mouse: Vector2):
	return Plane(Vector3.UP, 0.0).intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))

func robot_at(at: Transform) -> void:
	robot = at.origin
	push()

# A spring from the robot to the hand.
func push() -> void:
	if body == null:
		return
	var apart := target - robot
	apart.y = 0.0
	body.push_n = apart.normalized() * min(apart.length() * STIFFNESS_NPM, MOST_N) if held else Vector3()

func flat_distance(a: Vector3, b: Vector3) -> float:
	return Vector2(a.x - b.x, a.z - b.z).length()

func click(point: Vector3) -> void:
	for obstacle in obstacles:
		var local: Vector3 = obstacle.transform.origin
		if abs(local.x - point.x) <= OBSTACLE_M.x / 2 and abs(local.z - point.z) <= OBSTACLE_M.z / 2:
			obstacles.erase(obstacle)
			obstacle.queue_free()
			print("obstacle: taken away")
			return
	obstacles.append(terrain.add_obstacle(point, OBSTACLE_M))
	print("obstacle: %.3f m forward, %.3f m to the left" % [-point.z, -point.x])

func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventMouseButton and event.button_index == BUTTON_LEFT:
		var point = floor_at(event.position)
		if not event.pressed:
			held = false
			push()
		elif point != null and flat_distance(point, robot) <= REACH_M:
			held = true
			target = point
			print("robot: held")
		elif point != null:
			click(point)
	elif event is InputEventMouseMotion and held:
		var point = floor_at(event.position)
		if point != null:
			target = point
			push()
