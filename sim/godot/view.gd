# The visible scene: the robot, a ghost for each estimate, three paths, figures and cameras; or images of a film.
# Blue is the course's path, red that of the robot in this world, yellow that of the real robot on its own flat floor by
# the estimate that steers.
extends Spatial

const Frame = preload("res://frame.gd")
const Floor = preload("res://floor.gd")
const RobotView = preload("res://robot_view.gd")

const FRAME_MS := 33
const PATH_SPACING_M := 0.01
const PATH_WIDTH_M := 0.008
const MOST_POINTS := 20000
const BLUE := Color(0.1, 0.3, 0.95)
const RED := Color(0.9, 0.1, 0.1)
const YELLOW := Color(0.98, 0.8, 0.05)
const GHOSTS := {
	"model": Color(0.95, 0.45, 0.1, 0.3),
	"odometry": Color(0.1, 0.6, 0.95, 0.3),
	"fused": Color(0.1, 0.75, 0.35, 0.3),
}

var robot: Spatial
var ghosts = {}           # the real robot on its flat floor, by the name of the estimate
var camera = Camera.new()
var label = Label.new()
var reference = []        # the course's path, places in metres
var driven = {}           # colour name: {points, geometry}
var middle = Vector3()    # of the fence
var mode = "chase"
var film = ""             # folder for the film's images; empty: no film
var film_step_s = 0.0
var next_image_s = -1.0
var image_due = false
var images = 0
var drawn_ms = 0      # when the last frame was begun
var next_frame_ms = 0
var run = -1
var shift = Transform2D() # from the real robot's floor to this world
var last_s = 0.0
var title = ""

func build(settings: Dictionary) -> void:
	title = settings.title
	film = settings.get("film", "")
	film_step_s = settings.get("film_step_s", 0.08)
	mode = settings.get("camera", "chase")
	add_lights()
	add_floor(settings.course.fence)
	var shape: Dictionary = settings.robot.get("shape", {})
	robot = RobotView.new()
	add_child(robot)
	robot.build(shape)
	for estimate in GHOSTS:
		ghosts[estimate] = RobotView.new()
		add_child(ghosts[estimate])
		ghosts[estimate].build(shape, GHOSTS[estimate])
		ghosts[estimate].visible = false
	camera.current = true
	camera.fov = 50
	camera.near = 0.01
	add_child(camera)
	trace(settings.course.path)
	for colour in [["red", RED, 0.004], ["yellow", YELLOW, 0.003]]:
		driven[colour[0]] = {"points": [], "geometry": ribbon(colour[1]), "lift": colour[2]}
	var canvas = CanvasLayer.new()
	label.rect_position = Vector2(14, 10)
	label.add_color_override("font_color", Color(0.05, 0.05, 0.1))
	canvas.add_child(label)
	add_child(canvas)
	place_camera(1.0)
	VisualServer.render_loop_enabled = film.empty()

func add_lights() -> void:
	var sun = DirectionalLight.new()
	sun.rotation_degrees = Vector3(-55, 35, 0)
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 4.0
	sun.light_energy = 0.55
	add_child(sun)
	var air = Environment.new()
	air.background_mode = Environment.BG_COLOR
	air.background_color = Color(0.72, 0.8, 0.88)
	air.ambient_light_color = Color(0.85, 0.9, 1.0)
	air.ambient_light_energy = 0.4
	var world = WorldEnvironment.new()
	world.environment = air
	add_child(world)

func add_floor(fence: Dictionary) -> void:
	add_child(Floor.new())
	# The fence as rails.
	var rails = []
	for corner in fence.corners + [fence.corners[0]]:
		rails.append([corner.x_m, corner.y_m, 0])
	middle = Frame.to_engine((fence.min_x_m + fence.max_x_m) / 2, (fence.min_y_m + fence.max_y_m) / 2, 0)
	draw_ribbon(ribbon(Color(0.35, 0.35, 0.38)), rails, 0.002)

func ribbon(colour: Color) -> ImmediateGeometry:
	var geometry = ImmediateGeometry.new()
	var material = SpatialMaterial.new()
	material.flags_unshaded = true
	material.albedo_color = colour
	material.params_cull_mode = SpatialMaterial.CULL_DISABLED
	geometry.material_override = material
	geometry.cast_shadow = GeometryInstance.SHADOW_CASTING_SETTING_OFF
	add_child(geometry)
	return geometry

func draw_ribbon(geometry: ImmediateGeometry, points: Array, lift_m: float) -> void:
	geometry.clear()
	if points.size() < 2:
		return
	geometry.begin(Mesh.PRIMITIVE_TRIANGLE_STRIP)
	for i in points.size():
		var before: Array = points[max(i - 1, 0)]
		var after: Array = points[min(i + 1, points.size() - 1)]
		var across = Vector2(before[1] - after[1], after[0] - before[0]).normalized() * (PATH_WIDTH_M / 2)
		for side in [-1, 1]:
			geometry.add_vertex(Frame.to_engine(points[i][0] + side * across.x, points[i][1] + side * across.y,
					points[i][2] + lift_m))
	geometry.end()

func trace(path: Array) -> void:
	var points = []
	for p in path:
		points.append([p[0], p[1], 0.0])
		reference.append(Vector2(p[0], p[1]))
	draw_ribbon(ribbon(BLUE), points, 0.002)

func cross_track_m(x_m: float, y_m: float) -> float:
	var here = Vector2(x_m, y_m)
	var best = 1e9
	for i in range(1, reference.size()):
		best = min(best, here.distance_to(Geometry.get_closest_point_to_segment_2d(here, reference[i - 1], reference[i])))
	return best

func extend(colour: String, x_m: float, y_m: float, z_m: float) -> void:
	var path: Dictionary = driven[colour]
	var points: Array = path.points
	if points.size() > 0 and Vector2(points[-1][0] - x_m, points[-1][1] - y_m).length() < PATH_SPACING_M:
		return
	if points.size() < MOST_POINTS:
		points.append([x_m, y_m, z_m])
	draw_ribbon(path.geometry, points, path.lift)

# Shows the robot as in the answer to this pose.
func robot_at(at: Transform, message: Dictionary, frame: Reference) -> void:
	var on_floor: Array = frame.place_from(message.floor.pos)
	var floor_yaw: float = frame.yaw_from(message.floor.yaw)
	var rpy = Frame.angles(at.basis)
	var x = -at.origin.z
	var y = -at.origin.x
	if int(message.run) != run:
		run = int(message.run)
		for colour in driven:
			driven[colour].points.clear()
		var from = Transform2D(floor_yaw, Vector2(on_floor[0], on_floor[1]))
		shift = Transform2D(rpy[2], Vector2(x, y)) * from.affine_inverse()
		next_image_s = message.timestamp
	last_s = message.timestamp
	robot.transform = at
	robot.drive(message, frame)
	var real = shift.xform(Vector2(on_floor[0], on_floor[1]))
	var apart = place_ghosts(message, frame, Vector2(x, y))
	extend("red", x, y, at.origin.y)
	extend("yellow", real.x, real.y, 0.0)
	image_due = image_due or (not film.empty() and next_image_s >= 0 and last_s >= next_image_s)
	if film.empty() and OS.get_ticks_msec() - drawn_ms < FRAME_MS:
		return
	label.text = "%s    %s    %.1f s    tracks %.3f  %.3f m/s\ncross-track error %.1f cm    height %.1f cm    pitch %.1f deg    roll %.1f deg\nfrom here to the real robot on its flat floor%s\nblue: course    red: robot in this world    yellow: real robot by %s" % [
			title, message.get("mode", ""), last_s, message.tracks.l / frame.length(), message.tracks.r / frame.length(),
			100 * cross_track_m(x, y), 100 * at.origin.y, -rad2deg(rpy[1]), rad2deg(rpy[0]), apart, message.get("src", "")]
	place_camera(0.08)

# Shows each estimate of the real robot as a ghost. Returns its distance from the robot in this world, for the label.
func place_ghosts(message: Dictionary, frame: Reference, here: Vector2) -> String:
	var apart = ""
	var estimates = message.get("estimates")
	for estimate in ghosts:
		var found = estimates.get(estimate) if typeof(estimates) == TYPE_DICTIONARY else null
		ghosts[estimate].visible = Frame.is_floor_pose(found)
		if not ghosts[estimate].visible:
			continue
		var place: Array = frame.place_from(found.pos)
		var real = shift.xform(Vector2(place[0], place[1]))
		ghosts[estimate].transform = Transform(Frame.basis(0, 0, frame.yaw_from(found.yaw) + shift.get_rotation()), Frame.to_engine(real.x, real.y, 0))
		apart += "    %s %.1f cm" % [estimate, 100 * (real - here).length()]
	return apart

func place_camera(share: float) -> void:
	match mode:
		"top":
			camera.transform = Transform(Basis(Vector3.RIGHT, -PI / 2), middle + Vector3(0, 2.5, 0))
		_:
			var flat = Vector3(-robot.transform.basis.z.x, 0, -robot.transform.basis.z.z).normalized()
			var wanted = robot.transform.origin - flat * 0.5 + flat.cross(Vector3.UP) * 0.28 + Vector3(0, 0.36, 0)
			camera.translation = camera.translation.linear_interpolate(wanted, share)
			camera.look_at(robot.transform.origin + flat * 0.12 + Vector3(0, 0.02, 0), Vector3.UP)

# Call once per engine iteration: draws at 30 Hz at most and for a quarter of the time at most, so that drawing does not
# delay answers; for a film exactly the images that are due.
func turn() -> void:
	if not film.empty():
		if VisualServer.render_loop_enabled:
			save_image()
		VisualServer.render_loop_enabled = image_due
		return
	var now_ms = OS.get_ticks_msec()
	if VisualServer.render_loop_enabled:
		next_frame_ms = max(drawn_ms + FRAME_MS, now_ms + 3 * (now_ms - drawn_ms))
	VisualServer.render_loop_enabled = now_ms >= next_frame_ms
	if VisualServer.render_loop_enabled:
		drawn_ms = now_ms

func save_image() -> void:
	var image = get_viewport().get_texture().get_data()
	image.flip_y()
	image.save_png("%s/%05d.png" % [film, images])
	images += 1
	image_due = false
	next_image_s += film_step_s

func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventKey and event.pressed and not event.echo:
		match event.scancode:
			KEY_1:
				mode = "chase"
			KEY_2:
				mode = "top"
		place_camera(1.0)
