# Floor, ramps, blocks and surfaces of a course as the engine's shapes, and how the robot rests on them.
extends Spatial

const Frame = preload("res://frame.gd")

# Collision layers: ground that carries the robot, and surfaces that only have a name.
const GROUND := 1
const SURFACE := 2
const RAY_SPACING_M := 0.004
const RAY_TOP_M := 3.0
# A shape this high above the tracks' underside cannot be climbed: it blocks the hull.
const TOO_HIGH_M := 0.045
const TRACK_WIDTH_M := 0.045
const COLOURS = {"ramp": Color(0.62, 0.52, 0.38), "block": Color(0.5, 0.52, 0.56)}

var space: RID
var length_m: float
var gauge_m: float
var spacing_m: float
var radius_m: float
var com_forward_m: float
var half: int        # number of rays from the robot's middle to one end of its tracks
var wheel: PoolRealArray  # lift of a wheel's underside at each ray from its axle

func build(course: Dictionary, shape: Dictionary, of_space: RID) -> void:
	space = of_space
	spacing_m = shape.get("axle_spacing_m", 0.133)
	radius_m = shape.get("wheel_radius_m", 0.026)
	gauge_m = shape.get("gauge_m", 0.155)
	length_m = shape.get("length_m", 0.185)
	com_forward_m = shape.get("com_forward_m", 0.0)
	half = int(ceil((spacing_m / 2 + radius_m) / RAY_SPACING_M))
	var reach := int(floor(radius_m / RAY_SPACING_M))
	for i in range(-reach, reach + 1):
		wheel.append(sqrt(radius_m * radius_m - pow(i * RAY_SPACING_M, 2)) - radius_m)
	var slab := BoxShape.new()
	slab.extents = Vector3(20, 0.5, 20)
	add_shape(slab, Transform(Basis(), Vector3(0, -0.5, 0)), GROUND, {"kind": "floor"})
	for obstacle in course.obstacles:
		add_prism(obstacle)
	# Of overlapping surfaces, the last one lies on top.
	var top := 1.0
	for surface in course.surfaces:
		var box := BoxShape.new()
		box.extents = Vector3(surface.width_m / 2, 0.0005, surface.length_m / 2)
		var at := transform_of(surface)
		at.origin.y = top
		top += 0.01
		add_shape(box, at, SURFACE, {"kind": "surface", "name": surface.name})
		add_sheet(surface)

static func transform_of(piece: Dictionary) -> Transform:
	return Transform(Frame.basis(0, 0, piece.heading_rad), Frame.to_engine(piece.x_m, piece.y_m, 0))

func add_shape(shape: Shape, at: Transform, layer: int, about: Dictionary) -> void:
	var body := StaticBody.new()
	var collision := CollisionShape.new()
	collision.shape = shape
	body.add_child(collision)
	body.transform = at
	body.collision_layer = layer
	body.collision_mask = 0
	var smooth := PhysicsMaterial.new()
	smooth.friction = 0.0  # traction is the tracked body's own
	body.physics_material_override = smooth
	body.set_meta("about", about)
	add_child(body)
	PhysicsServer.body_set_space(body.get_rid(), space)

# Adds an obstacle of any kind: its side view, over its width.
func add_prism(piece: Dictionary) -> void:
	var side: float = piece.width_m / 2
	var height_m := 0.0
	var points := PoolVector3Array()
	for across in [side, -side]:
		for p in piece.profile:
			points.append(Frame.to_engine(p.along_m, across, p.height_m))
			height_m = max(height_m, p.height_m)
	var convex := ConvexPolygonShape.new()
	convex.points = points
	convex.margin = 0.001
	add_shape(convex, transform_of(piece), GROUND, {"kind": piece.kind, "height_m": height_m})
	var surface := SurfaceTool.new()
	surface.begin(Mesh.PRIMITIVE_TRIANGLES)
	for quad in [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 3, 2, 1], [4, 5, 6, 7]]:
		for i in [0, 1, 2, 0, 2, 3]:
			surface.add_vertex(points[quad[i]])
	surface.generate_normals()
	show_mesh(surface.commit(), transform_of(piece), COLOURS.get(piece.kind, COLOURS.ramp))

func add_sheet(piece: Dictionary) -> void:
	var sheet := PlaneMesh.new()
	sheet.size = Vector2(piece.width_m, piece.length_m)
	var at := transform_of(piece)
	at.origin.y = 0.0008
	show_mesh(sheet, at, Color(0.45, 0.6, 0.72))

func show_mesh(mesh: Mesh, at: Transform, colour: Color) -> void:
	var instance := MeshInstance.new()
	var material := SpatialMaterial.new()
	material.albedo_color = colour
	material.roughness = 0.9
	material.params_cull_mode = SpatialMaterial.CULL_DISABLED
	instance.mesh = mesh
	instance.transform = at
	instance.material_override = material
	add_child(instance)

# Whether only the floor lies under the rays of both tracks: then one ray per track is enough, and an answer takes a
# fraction of the time.
func on_floor(state: PhysicsDirectSpaceState, middle: Vector3, attitude: Basis) -> bool:
	var query := PhysicsShapeQueryParameters.new()
	var box := BoxShape.new()
	box.extents = Vector3(gauge_m / 2 + 0.001, RAY_TOP_M, (half + 1) * RAY_SPACING_M)
	query.set_shape(box)
	query.collision_mask = GROUND
	query.transform = Transform(attitude, middle)
	for found in state.intersect_shape(query):
		if found.collider.get_meta("about").kind != "floor":
			return false
	return true

# Heights of the ground along one track, at the rays -reach to +reach from the middle.
func profile(state: PhysicsDirectSpaceState, middle: Vector3, along: Vector3, reach: int) -> PoolRealArray:
	var heights := PoolRealArray()
	for i in range(-reach, reach + 1):
		var from := middle + along * (i * RAY_SPACING_M)
		from.y = RAY_TOP_M
		var hit := state.intersect_ray(from, from - Vector3(0, 2 * RAY_TOP_M, 0), [], GROUND)
		heights.append(hit.position.y if hit else 0.0)
	return heights

# How one track rests on the profile: the lowest line through its axles for which wheels and track do not cut the
# ground, as [height at the middle less the wheel radius, climb angle], supported on both sides of the centre of mass.
func rest(heights: PoolRealArray) -> Array:
	var first: float = heights[0]
	var level := true
	for h in heights:
		if h != first:
			level = false
			break
	if level:
		return [first, 0.0]
	var lowest := axle_heights(heights)
	var middle := (lowest.size() - 1) / 2
	var mass := int(round(com_forward_m / RAY_SPACING_M))
	var line := [0.0, 0.0]
	for _pass in range(2):  # the axles' horizontal distance depends on the climb angle
		var axle := int(min(round(spacing_m / 2 * cos(line[1]) / RAY_SPACING_M), middle))
		line = line_over(lowest, middle, axle, int(clamp(mass, -axle, axle - 1)))
	return line

# The least height of an axle, less the wheel's radius, at each ray of the track between its axles.
func axle_heights(heights: PoolRealArray) -> PoolRealArray:
	var axles := int(round(spacing_m / 2 / RAY_SPACING_M))
	var wide := (wheel.size() - 1) / 2
	var lowest := PoolRealArray()
	for i in range(half - axles, half + axles + 1):
		var best := -1e9
		for k in range(int(max(-wide, -i)), int(min(wide, heights.size() - 1 - i)) + 1):
			var here: float = heights[i + k] + wheel[k + wide]
			if here > best:
				best = here
		lowest.append(best)
	return lowest

# The lowest line above all points that carries the mass: [height at the middle, climb angle]. It goes through one point
# behind the mass and one ahead of it, which are improved in turn.
func line_over(lowest: PoolRealArray, middle: int, axle: int, mass: int) -> Array:
	var behind := -axle
	var ahead := axle
	var slope: float = (lowest[middle + ahead] - lowest[middle + behind]) / (ahead - behind)
	for _turn in lowest.size():
		var better := false
		for i in range(-axle, mass + 1):
			var here: float = (lowest[middle + ahead] - lowest[middle + i]) / (ahead - i)
			if here < slope:
				slope = here
				behind = i
				better = true
		for j in range(mass + 1, axle + 1):
			var here: float = (lowest[middle + j] - lowest[middle + behind]) / (j - behind)
			if here > slope:
				slope = here
				ahead = j
				better = true
		if not better:
			break
	return [lowest[middle + behind] - slope * behind, atan(slope / RAY_SPACING_M)]

# How the robot rests at a place: {z_m, pitch_rad, roll_rad, surface}.
func stand(x_m: float, y_m: float, yaw_rad: float) -> Dictionary:
	var state := PhysicsServer.space_get_direct_state(space)
	var attitude := Frame.basis(0, 0, yaw_rad)
	var middle := Frame.to_engine(x_m, y_m, 0)
	var aside := -attitude.x * (gauge_m / 2)
	var reach := 0 if on_floor(state, middle, attitude) else half
	var left := rest(profile(state, middle + aside, -attitude.z, reach))
	var right := rest(profile(state, middle - aside, -attitude.z, reach))
	var from := middle + Vector3(0, RAY_TOP_M, 0)
	var hit := state.intersect_ray(from, middle, [], SURFACE)
	return {
		"z_m": (left[0] + right[0]) / 2,
		"pitch_rad": -(left[1] + right[1]) / 2,
		"roll_rad": atan2(left[0] - right[0], gauge_m),
		"surface": hit.collider.get_meta("about").name if hit else ""}

# What tracks and hull touch at a pose: {step_m: height of a block, blocked: the hull's front touches}.
func touch(at: Transform) -> Dictionary:
	var state := PhysicsServer.space_get_direct_state(space)
	var query := PhysicsShapeQueryParameters.new()
	var box := BoxShape.new()
	box.margin = 0.001
	box.extents = Vector3((gauge_m + TRACK_WIDTH_M) / 2, 0.02, length_m / 2 + 0.002)
	query.set_shape(box)
	query.collision_mask = GROUND
	query.transform = at * Transform(Basis(), Vector3(0, 0.019, 0))
	var step_m := 0.0
	for found in state.intersect_shape(query):
		var about: Dictionary = found.collider.get_meta("about")
		if about.kind == "block":
			step_m = max(step_m, about.height_m)
	# The hull's front, above the height that the tracks can climb.
	box.extents = Vector3(gauge_m / 2, 0.005, 0.005)
	query.transform = at * Transform(Basis(), Vector3(0, TOO_HIGH_M + 0.005, -length_m / 2))
	return {"step_m": min(step_m, 1.0), "blocked": not state.intersect_shape(query, 1).empty()}
