# A person's hand that reaches over the robot, stays above it for a moment and withdraws.
extends Spatial

const AWAY_M := 1.3
const REACH_S := 0.9
const REST_S := 0.6
const HEIGHT_M := 0.22
const SKIN := Color(0.82, 0.6, 0.48)

var boxes = []  # [place, size]

func _init():
	add(Vector3(0.085, 0.03, 0.1), Vector3())
	for i in 4:
		add(Vector3(0.018, 0.018, 0.08), Vector3(-0.033 + 0.022 * i, 0, -0.09))
	add(Vector3(0.02, 0.02, 0.065), Vector3(0.055, 0, -0.01))
	add(Vector3(0.07, 0.06, 0.5), Vector3(0, 0.01, 0.29))
	visible = false

func add(size: Vector3, at: Vector3) -> void:
	var part := MeshInstance.new()
	var mesh := CubeMesh.new()
	mesh.size = size
	part.mesh = mesh
	part.translation = at
	var material := SpatialMaterial.new()
	material.albedo_color = SKIN
	part.material_override = material
	add_child(part)
	boxes.append([Transform(Basis(), at), size])

# Places the hand at the time `t_s`: at the times `at_s` it reaches for the robot at `robot`, from the right.
func reach(t_s: float, at_s: Array, robot: Vector3) -> void:
	visible = false
	for begin_s in at_s:
		var since_s: float = t_s - begin_s
		if since_s < 0 or since_s > 2 * REACH_S + REST_S:
			continue
		visible = true
		var share := 1.0 - smoothstep(0.0, REACH_S, since_s) + smoothstep(REACH_S + REST_S, 2 * REACH_S + REST_S, since_s)
		transform = Transform(Basis(Vector3.UP, PI / 2), robot + Vector3(AWAY_M * share, HEIGHT_M, 0))

# Whether it is between two points.
func hides(from: Vector3, to: Vector3) -> bool:
	if not visible:
		return false
	for part in boxes:
		var local: Transform = (transform * part[0]).affine_inverse()
		if AABB(-part[1] / 2, part[1]).intersects_segment(local.xform(from), local.xform(to)):
			return true
	return false
