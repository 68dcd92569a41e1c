# An overhead camera: renders images of a recorded drive and sends them to tp100-camera, in lockstep with it; or follows
# a robot that drives now, whose pose it receives, with as many images as it can render. The script that starts it passes
# the settings as JSON in the environment and judges the detections.
extends Node

const Frame = preload("res://frame.gd")
const Terrain = preload("res://terrain.gd")
const Floor = preload("res://floor.gd")
const MarkedRobot = preload("marked_robot.gd")
const Plate = preload("marker_plate.gd")
const PassingHand = preload("passing_hand.gd")

const JITTER_PX = [Vector2(-0.125, -0.375), Vector2(0.375, -0.125), Vector2(0.125, 0.375), Vector2(-0.375, 0.125)]
const PLATE_POINTS := 4  # parts of a side of the marker whose ends are tested for visibility

var settings := {}
var drive = []           # [t, x, y, z, roll, pitch, yaw] in course axes
var live: PacketPeerUDP  # receives the robot's pose; null: the drive is in a file
var live_s := 0.0        # time of the current image, if live
var over := false        # the sender of poses has ended
var row := 0             # row of the drive at which the last pose was found
var pinhole := Viewport.new()
var sensor := Viewport.new()
var shader := ShaderMaterial.new()
var camera := Camera.new()
var robot: Spatial
var hand: Spatial
var board: MeshInstance  # calibration board held in front of the lens; null: none
var lamp: SpotLight      # moving light; null: the light does not move
var middle := Vector3()
var pipe := StreamPeerTCP.new()
var truth := File.new()
var images := 0
var subframes := 0        # per image
var subframe := -2        # the engine's first two are not used

func _ready() -> void:
	var parsed := JSON.parse(OS.get_environment("TP100_OVERHEAD"))
	if parsed.error != OK or typeof(parsed.result) != TYPE_DICTIONARY:
		fail("TP100_OVERHEAD: no settings; a script starts this scene")
		return
	settings = parsed.result
	PhysicsServer.set_active(false)
	if settings.has("follow"):
		live = PacketPeerUDP.new()
		live.connect_to_host("127.0.0.1", int(settings.follow))
		live.put_packet("follow".to_ascii())
	else:
		read_drive()
		if drive.size() < 2:
			fail("%s: is not a drive" % settings.drive)
			return
	build_scene()
	build_sensor()
	if truth.open(settings.truth, File.WRITE) != OK:
		fail("%s: cannot be written" % settings.truth)
		return
	truth.store_line("t_s,x_m,y_m,yaw_rad,visible")
	if pipe.connect_to_host("127.0.0.1", int(settings.port)) != OK:
		fail("no tp100-camera at port %d" % settings.port)

func fail(text: String) -> void:
	printerr(text)
	get_tree().quit(2)
	set_process(false)

func read_drive() -> void:
	var file := File.new()
	if file.open(settings.drive, File.READ) != OK:
		return
	while not file.eof_reached():
		var numbers := file.get_line().split_floats(",")
		if numbers.size() == 7:
			drive.append(numbers)

# Receives the robot's pose as datagrams of an exact camera. Any other datagram is the last.
func hear() -> void:
	while live.get_available_packet_count() > 0:
		var seen = JSON.parse(live.get_packet().get_string_from_utf8()).result
		if typeof(seen) != TYPE_DICTIONARY or not seen.has("stamp_us"):
			over = true
			return
		var yaw: float = seen.yaw_rad
		if not drive.empty():
			yaw = drive[-1][6] + wrapf(yaw - drive[-1][6], -PI, PI)
		drive.append([seen.stamp_us * 1e-6, seen.x_m, seen.y_m, 0.0, 0.0, 0.0, yaw])

# The scene: floor, course, markers, robot, light.

func build_scene() -> void:
	pinhole.size = Vector2(settings.pinhole.width_px, settings.pinhole.height_px)
	pinhole.own_world = true
	pinhole.usage = Viewport.USAGE_3D
	pinhole.render_target_update_mode = Viewport.UPDATE_ALWAYS
	pinhole.render_target_v_flip = true
	pinhole.shadow_atlas_size = 1024
	var shape: Dictionary = settings.robot.get("shape", {})
	var ground := Floor.new()
	# Seen from above, it costs much and changes nothing.
	ground.material_override.albedo_texture.flags &= ~Texture.FLAG_ANISOTROPIC_FILTER
	pinhole.add_child(ground)
	var terrain := Terrain.new()
	pinhole.add_child(terrain)
	terrain.build(settings.course, shape, pinhole.find_world().space)
	for sheet in settings.floor_markers:
		var plate := Plate.new()
		pinhole.add_child(plate)
		plate.build(sheet.file, sheet.side_m, 0.0)
		plate.transform = Transform(Basis(Vector3.UP, deg2rad(sheet.turned_deg)), Frame.to_engine(sheet.x_m, sheet.y_m, 0.0004))
	robot = MarkedRobot.new()
	robot.sheet = settings.marker
	pinhole.add_child(robot)
	robot.build(shape)
	hand = PassingHand.new()
	pinhole.add_child(hand)
	if settings.has("board"):
		add_board()
	var place: Dictionary = settings.place
	middle = Frame.to_engine(place.middle_x_m, place.middle_y_m, 0)
	camera.fov = rad2deg(2 * atan(pinhole.size.y / 2 / settings.pinhole.focal_px))
	camera.near = 0.05
	camera.far = 20
	# The course's y axis is up in the image, apart from the camera's own rotation.
	camera.transform = Transform(Basis(), Frame.to_engine(place.x_m, place.y_m, place.height_m)).looking_at(
			middle, Vector3.LEFT.rotated(Vector3.UP, deg2rad(place.turned_deg)))
	pinhole.add_child(camera)
	camera.current = true
	add_light()

func add_board() -> void:
	var image := Image.new()
	if image.load(settings.board.file) != OK:
		printerr("%s: cannot be read as an image" % settings.board.file)
		return
	# The print has more detail than the lens resolves; and a power of two can be halved without a remainder.
	image.shrink_x2()
	image.shrink_x2()
	image.resize(2048, 2048, Image.INTERPOLATE_BILINEAR)
	var plane := PlaneMesh.new()
	plane.size = Vector2(settings.board.width_m, settings.board.height_m)
	board = MeshInstance.new()
	board.mesh = plane
	board.material_override = Plate.paper(image)
	pinhole.add_child(board)
	robot.visible = false

func add_light() -> void:
	var moving: bool = settings.light == "moving"
	var air := Environment.new()
	air.background_mode = Environment.BG_COLOR
	air.ambient_light_color = Color(0.85, 0.9, 1.0)
	air.ambient_light_energy = 0.25 if moving else 0.5
	camera.environment = air
	if not moving:
		var sun := DirectionalLight.new()
		sun.rotation_degrees = Vector3(-55, 35, 0)
		sun.shadow_enabled = true
		sun.directional_shadow_mode = DirectionalLight.SHADOW_ORTHOGONAL
		sun.directional_shadow_max_distance = 4.0
		sun.light_energy = 0.75
		pinhole.add_child(sun)
		return
	lamp = SpotLight.new()
	lamp.spot_range = 4.0
	lamp.spot_angle = 55.0
	lamp.spot_attenuation = 0.6
	lamp.shadow_enabled = true
	pinhole.add_child(lamp)

# A flickering lamp that is carried around the course once in nine seconds.
func move_light(t_s: float) -> void:
	if lamp == null:
		return
	var turn := TAU * t_s / 9.0
	var at := middle + Vector3(0.6 * cos(turn), 1.5, 0.9 * sin(turn))
	lamp.transform = Transform(Basis(), at).looking_at(middle + (at - middle) * Vector3(0.5, 0, 0.5), Vector3.LEFT)
	lamp.light_energy = 1.6 + 0.6 * sin(TAU * t_s / 1.7)

# The sensor: blends one subframe after another into its image.

func build_sensor() -> void:
	var lens: Dictionary = settings.lens
	sensor.size = Vector2(lens.width_px, lens.height_px)
	sensor.usage = Viewport.USAGE_2D
	sensor.render_target_update_mode = Viewport.UPDATE_ALWAYS
	sensor.render_target_clear_mode = Viewport.CLEAR_MODE_NEVER
	var screen := TextureRect.new()
	screen.expand = true
	screen.rect_size = sensor.size
	screen.material = shader
	sensor.add_child(screen)
	# Inside the sensor, because the engine draws a viewport after those inside it.
	sensor.add_child(pinhole)
	add_child(sensor)
	screen.texture = pinhole.get_texture()
	screen.texture.flags = Texture.FLAG_FILTER
	subframes = int(settings.in_exposure + settings.last_row_begins)
	shader.shader = preload("sensor.shader")
	for value in [["size_px", sensor.size], ["focal_px", lens.focal_px], ["centre_px", Vector2(lens.cx_px, lens.cy_px)],
			["k1", lens.k1], ["k2", lens.k2], ["pinhole_px", pinhole.size], ["pinhole_focal_px", settings.pinhole.focal_px],
			["in_exposure", settings.in_exposure], ["last_row_begins", settings.last_row_begins],
			["noise", settings.noise * sqrt(settings.in_exposure)]]:
		shader.set_shader_param(value[0], value[1])

# One subframe per engine iteration.
func _process(_delta: float) -> void:
	if pipe.get_status() == StreamPeerTCP.STATUS_CONNECTING:
		return
	if subframe == subframes:
		finish_image()
		subframe = 0
	if live != null:
		hear()
		if drive.size() < 2 and not over:
			return
		if subframe <= 0 and not over:
			live_s = drive[-1][0] - subframes / 2.0 * settings.subframe_spacing_s
	if over or (live == null and image_s() > settings.to_s):
		truth.close()
		pipe.disconnect_from_host()
		get_tree().quit()
		set_process(false)
		return
	var index := max(subframe, 0)
	var t_s: float = image_s() + (index - (subframes - 1) / 2.0) * settings.subframe_spacing_s
	place(t_s)
	move_light(t_s)
	shader.set_shader_param("index", float(index))
	shader.set_shader_param("jitter_px", JITTER_PX[index % JITTER_PX.size()])
	shader.set_shader_param("seed", float((images * subframes + index) % 997) + settings.seed)
	subframe += 1

func image_s() -> float:
	return live_s if live != null else settings.from_s + images / settings.rate_hz

func place(t_s: float) -> void:
	if board != null:
		var held: Array = settings.board.held[images]
		board.transform = camera.transform * Transform(Basis(Vector3.RIGHT, held[3]) * Basis(Vector3.UP, held[4])
				* Basis(Vector3.RIGHT, PI / 2), Vector3(held[0], held[1], -held[2]))
		return
	robot.transform = pose_at(t_s)
	hand.reach(t_s, settings.hand_at_s, robot.transform.origin)

func pose_at(t_s: float) -> Transform:
	while row > 0 and drive[row][0] > t_s:
		row -= 1
	while row + 2 < drive.size() and drive[row + 1][0] < t_s:
		row += 1
	var a = drive[row]
	var b = drive[row + 1]
	var share := clamp((t_s - a[0]) / (b[0] - a[0]), 0.0, 1.0)
	var p := []
	for i in range(1, 7):
		p.append(lerp(a[i], b[i], share))
	return Transform(Frame.basis(p[3], p[4], p[5]), Frame.to_engine(p[0], p[1], p[2]))

func finish_image() -> void:
	var image := sensor.get_texture().get_data()
	image.flip_y()
	if not settings.keep.empty():
		image.save_png("%s/%05d.png" % [settings.keep, images])
	image.convert(Image.FORMAT_L8)
	if board == null:
		tell_truth()
	pipe.put_data(("P5\n# taken_s %.6f\n%d %d\n255\n" % [image_s(), image.get_width(), image.get_height()]).to_ascii())
	if pipe.put_data(image.get_data()) != OK:
		fail("tp100-camera reads no more images")
	images += 1

# Writes the marker's true position: as seen from the lens, in the plane of its height above a flat floor.
func tell_truth() -> void:
	place(image_s())
	var front := seen(Vector3(0, 0, -settings.marker.size_m / 2))
	var back := seen(Vector3(0, 0, settings.marker.size_m / 2))
	var centre := seen(Vector3())
	var ahead := front - back
	truth.store_line("%.6f,%.6f,%.6f,%.6f,%d" % [image_s(), -centre.z, -centre.x, atan2(-ahead.x, -ahead.z), int(marker_visible())])

func on_marker(at: Vector3) -> Vector3:
	return robot.transform.xform(at + Vector3(0, settings.marker.height_m, 0))

func seen(at: Vector3) -> Vector3:
	var lens := camera.transform.origin
	var point := on_marker(at)
	return lens + (point - lens) * ((lens.y - settings.marker.height_m) / (lens.y - point.y))

# Whether the whole marker, including half of its white rim, is inside the image and nothing is in front of it.
func marker_visible() -> bool:
	var half: float = (settings.marker.size_m + settings.marker.side_m) / 4
	for i in PLATE_POINTS + 1:
		for k in PLATE_POINTS + 1:
			var point := on_marker(Vector3((2.0 * i / PLATE_POINTS - 1) * half, 0, (2.0 * k / PLATE_POINTS - 1) * half))
			if hand.hides(camera.transform.origin, point) or not Rect2(Vector2(), sensor.size).has_point(pixel(point)):
				return false
	return true

func pixel(point: Vector3) -> Vector2:
	var lens: Dictionary = settings.lens
	var local := camera.transform.affine_inverse().xform(point)
	var ray := Vector2(local.x, -local.y) / -local.z
	var r2 := ray.length_squared()
	return ray * (1 + r2 * (lens.k1 + r2 * lens.k2)) * lens.focal_px + Vector2(lens.cx_px, lens.cy_px)
