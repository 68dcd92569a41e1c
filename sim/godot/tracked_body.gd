# The robot as the engine's rigid body on two tracks: Bullet finds the contacts and keeps the body out of the ground,
# friction impulses at the contacts pull it along with the tracks' surfaces.
extends RigidBody

const Frame = preload("res://frame.gd")
const Terrain = preload("res://terrain.gd")

const FRICTION := 0.9
const SWEEPS := 6         # over all contacts, each tick
const CONTACTS := 32
const ROD_LIFT_M := 0.0015
const HULL := 6           # its index among the shapes

var left_mps := 0.0   # speeds of the tracks' surfaces
var right_mps := 0.0
var push_n := Vector3()  # on the reference point, horizontal
var com_height_m: float
var contacts := 0

func build(shape: Dictionary, body: Dictionary) -> void:
	com_height_m = body.get("com_height_m", 0.022)
	mass = body.get("mass_kg", 0.922)
	can_sleep = false
	contact_monitor = true
	contacts_reported = CONTACTS
	custom_integrator = false
	continuous_cd = false
	collision_layer = 4  # rays for the ground do not see it
	collision_mask = Terrain.GROUND | Terrain.OBSTACLE
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
	add_part(hull, Transform(Basis(), Vector3(0, 0.034 - com_height_m, 0)))

# A ball at each axle and a rod between them. The engine reports one point of contact per pair of shapes, so each of
# these must touch the ground at one point only; the rod is a little thinner, so that the ends carry the load.
func add_track(x: float, spacing_m: float, radius_m: float) -> void:
	for end in [-1, 1]:
		var ball := SphereShape.new()
		ball.radius = radius_m
		add_part(ball, Transform(Basis(), Vector3(x, radius_m - com_height_m, end * spacing_m / 2)))
	var rod := CapsuleShape.new()
	rod.radius = radius_m - ROD_LIFT_M
	rod.height = spacing_m
	add_part(rod, Transform(Basis(), Vector3(x, radius_m - com_height_m, 0)))

func add_part(part: Shape, place: Transform) -> void:
	var collision := CollisionShape.new()
	collision.shape = part
	collision.transform = place
	add_child(collision)

# Puts the robot's reference point to a place, at standstill.
func put(x_m: float, y_m: float, z_m: float, attitude: Basis) -> void:
	transform = Transform(attitude, Frame.to_engine(x_m, y_m, z_m) + attitude.y * com_height_m)
	linear_velocity = Vector3()
	angular_velocity = Vector3()

# Pose of the reference point.
func reference() -> Transform:
	return Transform(transform.basis, transform.origin - transform.basis.y * com_height_m)

# Coulomb friction at every contact of the tracks, by sequential impulses: each sweep brings a contact's sliding nearer
# to none, and no contact gives more than its load carries.
func _integrate_forces(state: PhysicsDirectBodyState) -> void:
	state.linear_velocity += push_n * state.inverse_mass * state.step
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
	for i in contacts:
		var arm: Vector3 = state.get_contact_collider_position(i) - state.transform.origin
		var normal: Vector3 = state.get_contact_local_normal(i)
		var local: Vector3 = b.xform_inv(arm)
		arms.append(arm)
		normals.append(normal)
		# The track runs around its outline: under the body it moves backward.
		var along: Vector3 = b.x.cross(normal)
		var speed := 0.0 if state.get_contact_local_shape(i) == HULL else (left_mps if local.x < 0 else right_mps)
		surface_speeds.append(along.normalized() * speed)
		load_ns.append(max(state.get_contact_impulse(i), 0.0))
		sum_ns += load_ns[-1]
		given.append(Vector3())
	if sum_ns <= 0.0:
		return
	var v: Vector3 = state.linear_velocity
	var w: Vector3 = state.angular_velocity
	for _sweep in SWEEPS:
		for i in contacts:
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
			var most: float = FRICTION * load_ns[i]
			if wanted.length() > most:
				wanted = wanted.normalized() * most
			var change: Vector3 = wanted - given[i]
			given[i] = wanted
			v += change * state.inverse_mass
			w += inverse_inertia.xform(arms[i].cross(change))
	state.linear_velocity = v
	state.angular_velocity = w
