# The visible floor, marked in squares of 10 cm like the paper's.
extends MeshInstance

const SIDE_M := 6.0

func _init():
	var image := Image.new()
	image.create(128, 128, false, Image.FORMAT_RGB8)
	image.fill(Color(0.86, 0.86, 0.83))
	image.lock()
	for i in 128:
		for k in 2:
			image.set_pixel(i, k, Color(0.6, 0.62, 0.62))
			image.set_pixel(k, i, Color(0.6, 0.62, 0.62))
	image.unlock()
	image.generate_mipmaps()
	var texture := ImageTexture.new()
	texture.create_from_image(image, Texture.FLAG_MIPMAPS | Texture.FLAG_FILTER | Texture.FLAG_REPEAT | Texture.FLAG_ANISOTROPIC_FILTER)
	var material := SpatialMaterial.new()
	material.albedo_texture = texture
	material.roughness = 1.0
	material.uv1_scale = Vector3(SIDE_M * 10, SIDE_M * 10, 1)
	var plane := PlaneMesh.new()
	plane.size = Vector2(SIDE_M, SIDE_M)
	mesh = plane
	material_override = material
