# The robot as a rigid body of the engine on two tracks: Bullet finds the contacts and keeps the body out of the ground;
# friction impulses at the contacts drive it with the tracks' surfaces.
extends RigidBody

const Frame = preload("res://frame.gd")
const Terrain = preload("res://terrain.gd")

const SWEEPS := 6         # solver iterations over all contacts in each tick
const CONTACTS := 32
const ROD_LIFT_M := 0.0015
const SHAPES := 3         # per track: front ball, rear ball, rod
const HULL := 6           # index of the hull among the shapes
const LEVEL_M := 0.001    # tolerance within which both ends of a track lie on one plane
# The ten stations of the emulator's tracks (sim/body/tracks.h): their depth under an even load, and the middle ones
# merged into four points with the same mean distance from the middle and the same mean square.
const SINK_M := 5.65e-5
const OUTER := 0.6929
const INNER := 0.1960

var left_mps := 0.0   # speeds of the tracks' surfaces
var right_mps := 0.0
var friction_coefficient: float
var com := Vector3()     # from the reference point to the centre of mass
var stations := []       # along a track on a plane, [position from -1 (rear axle) to 1, share of the track's load]
var second_moment := 0.0 # of the stations' shares
var contacts := 0

func build(shape: Dictionary, body: Dictionary) -> void:
	com = Vector3(-body.get("com_left_m", 0.0), body.get("com_height_m", 0.022), -body.get("com_forward_m", 0.0))
	friction_coefficient = body.get("friction", 0.9)
	spread_load(body.get("mid_lift_m", 0.0003))
	mass = body.get("mass_kg", 0.922)
	can_sleep = false
	contact_monitor = true
	contacts_reported = CONTACTS
	custom_integrator = false
	continuous_cd = false
	collision_layer = 4  # not hit by the rays for the ground
	collision_mask = Terrain.GROUND
	linear_damp = 0.0
	angular_damp = 0.0
	var smooth := PhysicsMaterial.new()
	smooth.friction = 0.0
	physics_material_override = smooth
	var gauge_m: float = shape.get("gauge_m", 0.155)
	for side in [-1, 1]:
		add_track(side * gauge_m / 2, shape.get("axle_spacing_m", 0.133), shape.get("wheel_radius_m", 0.026))
	var hull := BoxShape.new()
	hull.margin = 0.001
	hull.extents = Vector3(gauge_m / 2 - 0.03, 0.019, 0.075)
	add_part(hull, Transform(Basis(), Vector3(0, 0.034, 0)))

# Distributes the load of a track that lies on a plane as in the emulator: its tracks are springs with a raised middle.
func spread_load(mid_lift_m: float) -> void:
	var lifted := min(mid_lift_m / SINK_M, 5.0)  # from 5 on the middle touches nothing
	for end in [-1.0, 1.0]:
		stations.append([end, 0.1 + 0.08 * lifted])
		if lifted < 5.0:
			for place in [OUTER, INNER]:
				stations.append([end * place, 0.2 - 0.04 * lifted])
	for station in stations:
		second_moment += station[1] * station[0] * station[0]

# A ball at each axle and a rod between them. The engine reports one contact point per pair of shapes, so each of these
# must touch the ground at one point only; the rod is a little thinner, so that the ends carry the load.
func add_track(x: float, spacing_m: float, radius_m: float) -> void:
	for end in [-1, 1]:
		var ball := SphereShape.new()
		ball.radius = radius_m
		add_part(ball, Transform(Basis(), Vector3(x, radius_m, end * spacing_m / 2)))
	var rod := CapsuleShape.new()
	rod.radius = radius_m - ROD_LIFT_M
	rod.height = spacing_m
	add_part(rod, Transform(Basis(), Vector3(x, radius_m, 0)))

func add_part(part: Shape, place: Transform) -> void:
	var collision := CollisionShape.new()
	collision.shape = part
	collision.transform = place.translated(-com)
	add_child(collision)

# Places the robot with its reference point at this position, at standstill.
func put(x_m: float, y_m: float, z_m: float, attitude: Basis) -> void:
	transform = Transform(attitude, Frame.to_engine(x_m, y_m, z_m) + attitude.xform(com))
	linear_velocity = Vector3()
	angular_velocity = Vector3()

# Pose of the reference point.
func reference() -> Transform:
	return Transform(transform.basis, transform.origin - transform.basis.xform(com))

# Contacts of the body: [arm from the centre of mass, normal, load, speed of the track's surface]. The load of a track
# whose ends lie on one plane is distributed between them without changing its moment.
func touches(state: PhysicsDirectBodyState) -> Array:
	var found := []
	var ends := [null, null, null, null]  # front and rear of the left, of the right track
	for i in contacts:
		var shape: int = state.get_contact_local_shape(i)
		var speed := 0.0 if shape == HULL else (left_mps if shape < SHAPES else right_mps)
		var touch := [state.get_contact_collider_position(i) - state.transform.origin, state.get_contact_local_normal(i),
				max(state.get_contact_impulse(i), 0.0), speed]
		var end := shape % SHAPES
		if shape != HULL and end < 2 and ends[shape / SHAPES * 2 + end] == null:
			ends[shape / SHAPES * 2 + end] = touch
		else:
			found.append(touch)
	for side in 2:
		var front = ends[2 * side]
		var rear = ends[2 * side + 1]
		if stations.size() > 2 and front != null and rear != null and abs((front[0] - rear[0]).dot(front[1])) < LEVEL_M \
				and abs((front[0] - rear[0]).dot(rear[1])) < LEVEL_M and front[2] + rear[2] > 0.0:
			var middle: Vector3 = (front[0] + rear[0]) / 2
			var half: Vector3 = (front[0] - rear[0]) / 2
			var lean := clamp((front[2] - rear[2]) / (front[2] + rear[2]) / second_moment, -1.0, 1.0)
			for station in stations:
				found.append([middle + half * station[0], front[1],
						(front[2] + rear[2]) * station[1] * (1.0 + lean * station[0]), front[3]])
			continue
		for end in [front, rear]:
			if end != null:
				found.append(end)
	return found

# Coulomb friction at every contact of the tracks, by sequential impulses: each sweep reduces the sliding at a contact,
# with at most the friction coefficient times its load.
func _integrate_forces(state: PhysicsDirectBodyState) -> void:
	contacts = state.get_contact_count()
	if contacts == 0:
		return
	var b: Basis = state.transform.basis
	var diagonal: Vector3 = state.inverse_inertia
	var inverse_inertia := b * Basis(Vector3(diagonal.x, 0, 0), Vector3(0, diagonal.y, 0), Vector3(0, 0, diagonal.z)) * b.transposed()
	var arms := []
	var normals := []
	var surface_speeds := []
	var load_ns := []
	var given := []
	var sum_ns := 0.0
	for touch in touches(state):
		var arm: Vector3 = touch[0]
		var normal: Vector3 = touch[1]
		arms.append(arm)
		normals.append(normal)
		# The track moves around its outline: under the body it moves backward.
		surface_speeds.append(b.x.cross(normal).normalized() * touch[3])
		load_ns.append(touch[2])
		sum_ns += touch[2]
		given.append(Vector3())
	if sum_ns <= 0.0:
		return
	var v: Vector3 = state.linear_velocity
	var w: Vector3 = state.angular_velocity
	for _sweep in SWEEPS:
		for i in arms.size():
			if load_ns[i] == 0.0:
				continue
			var slide: Vector3 = v + w.cross(arms[i]) + surface_speeds[i]
			slide -= normals[i] * slide.dot(normals[i])
			var speed := slide.length()
			if speed < 1e-7:
				continue
			var direction := slide / speed
			var lever: Vector3 = arms[i].cross(direction)
			var weight: float = state.inverse_mass + lever.dot(inverse_inertia.xform(lever))
			var wanted: Vector3 = given[i] - slide / weight
			var most: float = friction_coefficient * load_ns[i]
			if wanted.length() > most:
				wanted = wanted.normalized() * most
			var change: Vector3 = wanted - given[i]
			given[i] = wanted
			v += change * state.inverse_mass
			w += inverse_inertia.xform(arms[i].cross(change))
	state.linear_velocity = v
	state.angular_velocity = w
