# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Coarse shapes, shaded smooth, that turn in Blender's viewport, for scripts/strangers: blender --python blender_scene.py."""
import bpy


def add_shapes():
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    bpy.ops.mesh.primitive_monkey_add(size=2.5, location=(0, 0, 0))
    bpy.ops.object.shade_smooth()
    bpy.ops.mesh.primitive_uv_sphere_add(segments=10, ring_count=7, location=(2.6, 0, 0))
    bpy.ops.object.shade_smooth()
    bpy.ops.mesh.primitive_cube_add(size=1.4, location=(-2.6, 0, 0))


def turn():
    for shape in bpy.data.objects:
        shape.rotation_euler[2] += 0.06
    return 0.1


def start():
    add_shapes()
    bpy.app.timers.register(turn, persistent=True)


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(start, first_interval=1)
