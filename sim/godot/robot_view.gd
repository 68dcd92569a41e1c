# The visible TP100: hull, two moving tracks, Arduino Mega. Origin: the reference point; -z is forward.
extends Spatial

const PADS := 38  # of each track

var spacing_m: float
var radius_m: float
var gauge_m: float
var pads = [[], []]
var travelled_m = [0.0, 0.0]
var last_s = 0.0

func build(shape: Dictionary, ghost := Color(0, 0, 0, 0)) -> void:
	spacing_m = shape.get("axle_spacing_m", 0.133)
	radius_m = shape.get("wheel_radius_m", 0.026)
	gauge_m = shape.get("gauge_m", 0.155)
	var solid = ghost.a == 0.0
	var inner = gauge_m - 0.05
	box(Vector3(inner, 0.026, 0.165), Vector3(0, 0.031, 0), Color(0.16, 0.17, 0.19) if solid else ghost)
	for side in 2:
		var x = (side - 0.5) * gauge_m
		box(Vector3(0.036, 2 * radius_m - 0.012, spacing_m), Vector3(x, radius_m, 0), Color(0.1, 0.1, 0.1) if solid else ghost)
		for end in [-1, 1]:
			wheel(Vector3(x, radius_m, end * spacing_m / 2), Color(0.85, 0.6, 0.1) if solid else ghost)
		if solid:
			for i in PADS:
				pads[side].append(box(Vector3(0.045, 0.005, 0.008), Vector3(), Color(0.07, 0.07, 0.08) if i % 2 else Color(0.2, 0.2, 0.21)))
	if not solid:
		return
	roll(0, 0.0)
	roll(1, 0.0)
	# The Mega on its spacers, its headers and its USB port, and the batteries.
	box(Vector3(0.0535, 0.002, 0.1016), Vector3(0.022, 0.048, 0.012), Color(0.0, 0.39, 0.45))
	for x in [-0.003, 0.046]:
		box(Vector3(0.004, 0.008, 0.085), Vector3(x, 0.053, 0.014), Color(0.04, 0.04, 0.04))
	box(Vector3(0.012, 0.01, 0.014), Vector3(0.012, 0.054, 0.06), Color(0.75, 0.75, 0.77))
	box(Vector3(0.014, 0.003, 0.014), Vector3(0.022, 0.0505, 0.0), Color(0.05, 0.05, 0.05))
	for x in [-0.012, -0.032]:
		box(Vector3(0.018, 0.018, 0.066), Vector3(x, 0.053, 0.03), Color(0.2, 0.35, 0.75))

func paint(instance: MeshInstance, colour: Color) -> void:
	var material = SpatialMaterial.new()
	material.albedo_color = colour
	material.roughness = 0.7
	if colour.a < 1.0:
		material.flags_transparent = true
		instance.cast_shadow = GeometryInstance.SHADOW_CASTING_SETTING_OFF
	instance.material_override = material

func box(size: Vector3, at: Vector3, colour: Color) -> MeshInstance:
	var instance = MeshInstance.new()
	var mesh = CubeMesh.new()
	mesh.size = size
	instance.mesh = mesh
	instance.translation = at
	paint(instance, colour)
	add_child(instance)
	return instance

func wheel(at: Vector3, colour: Color) -> void:
	var instance = MeshInstance.new()
	var mesh = CylinderMesh.new()
	mesh.top_radius = radius_m - 0.005
	mesh.bottom_radius = radius_m - 0.005
	mesh.height = 0.043
	instance.mesh = mesh
	instance.transform = Transform(Basis(Vector3.BACK, PI / 2), at)
	paint(instance, colour)
	add_child(instance)

# Moves the tracks by their travel since the last pose of the bridge.
func drive(message: Dictionary, frame: Reference) -> void:
	var passed_s = clamp(message.timestamp - last_s, 0.0, 0.1)
	last_s = message.timestamp
	roll(0, message.tracks.l / frame.length() * passed_s)
	roll(1, message.tracks.r / frame.length() * passed_s)

# Moves one track (0 left, 1 right) by a distance.
func roll(side: int, distance_m: float) -> void:
	var straight = spacing_m
	var bend = PI * radius_m
	var around = 2 * (straight + bend)
	travelled_m[side] = fposmod(travelled_m[side] + distance_m, around)
	var x = (side - 0.5) * gauge_m
	for i in pads[side].size():
		var s = fposmod(travelled_m[side] + i * around / PADS, around)
		var r = radius_m - 0.0025
		var place: Vector3
		var turn = 0.0
		# From the top's rear end forward, down the front wheel, back along the ground, up the rear wheel.
		if s < straight:
			place = Vector3(x, radius_m + r, straight / 2 - s)
		elif s < straight + bend:
			turn = (s - straight) / radius_m
			place = Vector3(x, radius_m + r * cos(turn), -straight / 2 - r * sin(turn))
		elif s < 2 * straight + bend:
			turn = PI
			place = Vector3(x, radius_m - r, -straight / 2 + (s - straight - bend))
		else:
			turn = PI + (s - 2 * straight - bend) / radius_m
			place = Vector3(x, radius_m + r * cos(turn), straight / 2 - r * sin(turn))
		pads[side][i].transform = Transform(Basis(Vector3.LEFT, turn), place)
