# The robot with a marker for an overhead camera, level above its reference point.
extends "res://robot_view.gd"

const Plate = preload("marker_plate.gd")

var sheet := {}  # {file, side_m, height_m}

func build(shape: Dictionary, ghost := Color(0, 0, 0, 0)) -> void:
	.build(shape, ghost)
	var plate = Plate.new()
	add_child(plate)
	plate.build(sheet.file, sheet.side_m, sheet.height_m)
	box(Vector3(0.012, sheet.height_m - 0.044, 0.012), Vector3(-0.022, (sheet.height_m + 0.04) / 2, -0.03), Color(0.3, 0.3, 0.3))
