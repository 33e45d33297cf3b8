# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
# Primitives, a body of CSG, instances, and shadows of a sun and of a lamp.
extends Spatial

var things = []

func paint(color):
	var material = SpatialMaterial.new()
	material.albedo_color = color
	material.roughness = 0.4
	return material

func put(mesh, color, place):
	var one = MeshInstance.new()
	one.mesh = mesh
	one.material_override = paint(color)
	one.translation = place
	add_child(one)
	things.append(one)

func _ready():
	var eye = Camera.new()
	eye.translation = Vector3(0, 2.6, 7)
	eye.rotation_degrees = Vector3(-18, 0, 0)
	add_child(eye)
	var sun = DirectionalLight.new()
	sun.rotation_degrees = Vector3(-50, 30, 0)
	sun.shadow_enabled = true
	add_child(sun)
	var lamp = OmniLight.new()
	lamp.translation = Vector3(-1, 2.5, 2)
	lamp.shadow_enabled = true
	lamp.light_color = Color(1, 0.7, 0.4)
	add_child(lamp)
	var ball = SphereMesh.new()
	ball.radial_segments = 12
	ball.rings = 6
	put(ball, Color(0.9, 0.3, 0.3), Vector3(-2.6, 0.4, 0))
	var capsule = CapsuleMesh.new()
	capsule.radius = 0.5
	capsule.radial_segments = 10
	capsule.rings = 3
	put(capsule, Color(0.3, 0.8, 0.4), Vector3(-0.8, 0.5, 0))
	var cylinder = CylinderMesh.new()
	cylinder.radial_segments = 9
	cylinder.rings = 1
	cylinder.top_radius = 0.3
	cylinder.bottom_radius = 0.7
	cylinder.height = 1.4
	put(cylinder, Color(0.3, 0.5, 0.9), Vector3(1, 0.3, 0))
	var body = CSGCombiner.new()
	var outer = CSGBox.new()
	outer.width = 1.3
	outer.height = 1.3
	outer.depth = 1.3
	var hole = CSGSphere.new()
	hole.radius = 0.85
	hole.operation = CSGShape.OPERATION_SUBTRACTION
	outer.material = paint(Color(0.9, 0.8, 0.3))
	body.add_child(outer)
	body.add_child(hole)
	body.translation = Vector3(2.8, 0.3, 0)
	add_child(body)
	things.append(body)
	var many = MultiMesh.new()
	many.transform_format = MultiMesh.TRANSFORM_3D
	many.mesh = ball
	many.instance_count = 10
	for i in range(10):
		many.set_instance_transform(i, Transform(Basis().scaled(Vector3(0.25, 0.25, 0.25)), Vector3(-2.7 + 0.6 * i, -0.4, 1.8)))
	var row = MultiMeshInstance.new()
	row.multimesh = many
	add_child(row)
	var ground = MeshInstance.new()
	ground.mesh = CubeMesh.new()
	ground.scale = Vector3(5, 0.1, 4)
	ground.translation = Vector3(0, -0.8, 0)
	ground.material_override = paint(Color(0.6, 0.65, 0.6))
	add_child(ground)

func _process(_time):
	for thing in things:
		thing.rotate_y(0.05)
		thing.rotate_object_local(Vector3(1, 0, 0), 0.02)
