# A printed ArUco marker on a stiff plate, as tp100-camera --print-marker draws it. Its top edge points to -z.
extends Spatial

const THICK_M := 0.002

# Matt paper printed with `image`.
static func paper(image: Image) -> SpatialMaterial:
	image.generate_mipmaps()
	var texture := ImageTexture.new()
	texture.create_from_image(image, Texture.FLAG_MIPMAPS | Texture.FLAG_FILTER)
	var material := SpatialMaterial.new()
	material.albedo_texture = texture
	material.roughness = 1.0
	return material

# `file`: the SVG; `side_m`: side of the sheet, including its white rim; `lift_m`: height of its face above the origin.
func build(file: String, side_m: float, lift_m: float) -> void:
	var image := Image.new()
	if image.load(file) != OK:
		printerr("%s: cannot be read as an image" % file)
		return
	var face := MeshInstance.new()
	var plane := PlaneMesh.new()
	plane.size = Vector2(side_m, side_m)
	face.mesh = plane
	face.material_override = paper(image)
	face.translation.y = lift_m
	add_child(face)
	var plate := MeshInstance.new()
	var box := CubeMesh.new()
	box.size = Vector3(side_m, THICK_M, side_m)
	plate.mesh = box
	plate.translation.y = lift_m - THICK_M / 2 - 0.0002
	add_child(plate)
