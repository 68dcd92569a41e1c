# Converts between the frames of world/1 messages and the engine's.
# Engine: metres, x right, y up, z backward. Course (ros): metres, x forward, y left, z up.
extends Reference

const NAMES = ["ros", "unreal", "unity"]

var name := "ros"

func _init(frame_name := "ros"):
	name = frame_name

func length() -> float:
	return 100.0 if name == "unreal" else 1.0

static func is_number(value) -> bool:
	return (typeof(value) == TYPE_REAL or typeof(value) == TYPE_INT) and not is_nan(value) and abs(value) < 1e12

static func are_numbers(value, size: int) -> bool:
	if typeof(value) != TYPE_ARRAY or value.size() != size:
		return false
	for one in value:
		if not is_number(one):
			return false
	return true

# Whether a value is a position and a yaw on the real robot's flat floor.
static func is_floor_pose(value) -> bool:
	return typeof(value) == TYPE_DICTIONARY and are_numbers(value.get("pos"), 3) and is_number(value.get("yaw"))

# Course coordinates in metres as a position of the engine.
static func to_engine(x_m: float, y_m: float, z_m: float) -> Vector3:
	return Vector3(-y_m, z_m, -x_m)

# Roll, pitch and yaw in radians (ros signs: nose up is a negative pitch) as the engine's attitude.
static func basis(roll_rad: float, pitch_rad: float, yaw_rad: float) -> Basis:
	return Basis(Vector3.UP, yaw_rad) * Basis(Vector3.LEFT, pitch_rad) * Basis(Vector3.FORWARD, roll_rad)

# The inverse: [roll, pitch, yaw] in radians.
static func angles(b: Basis) -> Array:
	var forward := -b.z
	var left := -b.x
	return [atan2(left.y, b.y.y), -asin(clamp(forward.y, -1.0, 1.0)), atan2(-forward.x, -forward.z)]

# A message's position as [x, y, z] in metres, ros axes.
func place_from(p: Array) -> Array:
	match name:
		"unreal":
			return [p[0] / 100.0, -p[1] / 100.0, p[2] / 100.0]
		"unity":
			return [p[2], -p[0], p[1]]
	return [p[0], p[1], p[2]]

func place(x_m: float, y_m: float, z_m: float) -> Array:
	match name:
		"unreal":
			return [100.0 * x_m, -100.0 * y_m, 100.0 * z_m]
		"unity":
			return [-y_m, z_m, x_m]
	return [x_m, y_m, z_m]

func rpy(roll_rad: float, pitch_rad: float, yaw_rad: float) -> Array:
	match name:
		"unreal":
			return [rad2deg(roll_rad), -rad2deg(pitch_rad), -rad2deg(yaw_rad)]
		"unity":
			return [-rad2deg(roll_rad), rad2deg(pitch_rad), -rad2deg(yaw_rad)]
	return [roll_rad, pitch_rad, yaw_rad]

# The message's yaw in radians, positive to the left.
func yaw_from(yaw: float) -> float:
	return yaw if name == "ros" else -deg2rad(yaw)
