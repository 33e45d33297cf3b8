# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Bakes a normal map in Blender (Cycles, selected to active), onto the texture coordinates of a model of glark bake.

blender --background --factory-startup --python-exit-code 1 --python blender_bake.py -- \\
    COARSE.glb FINE.glb WIDTH HEIGHT MARGIN THREADS EXTRUSION OUT.glb [EXTRUSION OUT.glb ...]

Prints one line for each extrusion, which is a length: glark: {"extrusion": ..., "seconds": ..., "processor_seconds": ...}
"""
import json
import sys
import time

import bpy
import numpy

numpy.bool = bool  # Debian 12: the glTF importer of Blender 3.4.1 uses this name, which NumPy 1.24 does not have


def load(file: str):
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=file)
    return next(thing for thing in bpy.data.objects if thing not in before and thing.type == "MESH")


def material_with(picture):
    material = bpy.data.materials.new("baked")
    material.use_nodes = True
    material.use_backface_culling = True  # as glark bake: otherwise open meshes show their insides
    nodes, links = material.node_tree.nodes, material.node_tree.links
    surface = nodes["Principled BSDF"]
    surface.inputs["Metallic"].default_value = 0
    surface.inputs["Roughness"].default_value = 0.8
    surface.inputs["Base Color"].default_value = (1, 1, 1, 1)
    texture, normals = nodes.new("ShaderNodeTexImage"), nodes.new("ShaderNodeNormalMap")
    texture.image = picture
    links.new(texture.outputs["Color"], normals.inputs["Color"])
    links.new(normals.outputs["Normal"], surface.inputs["Normal"])
    nodes.active = texture  # the target of the bake
    return material


def select(coarse, *others) -> None:
    bpy.ops.object.select_all(action="DESELECT")
    for thing in (coarse, *others):
        thing.select_set(True)
    bpy.context.view_layer.objects.active = coarse


def bake(coarse, fine, extrusion: float, margin: int) -> dict:
    select(coarse, fine)
    start, processor = time.perf_counter(), time.process_time()
    # Rays start at the extruded surface and go inwards, as far below the surface as they start above it.
    bpy.ops.object.bake(type="NORMAL", normal_space="TANGENT", use_selected_to_active=True, cage_extrusion=extrusion,
                        max_ray_distance=2 * extrusion, margin=margin, margin_type="EXTEND", use_clear=True)
    return {"seconds": time.perf_counter() - start, "processor_seconds": time.process_time() - processor}


def main() -> None:
    words = sys.argv[sys.argv.index("--") + 1:]
    coarse_file, fine_file = words[:2]
    width, height, margin, threads = (int(word) for word in words[2:6])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.render.threads_mode = "FIXED"
    scene.render.threads = threads
    coarse, fine = load(coarse_file), load(fine_file)
    picture = bpy.data.images.new("normals", width, height, alpha=False, is_data=True)
    coarse.data.materials.clear()
    coarse.data.materials.append(material_with(picture))
    for extrusion, out in zip(words[6::2], words[7::2], strict=True):
        times = bake(coarse, fine, float(extrusion), margin)
        picture.pack()
        select(coarse)
        bpy.ops.export_scene.gltf(filepath=out, export_format="GLB", use_selection=True, export_tangents=True)
        print("glark: " + json.dumps({"extrusion": float(extrusion), **times}), flush=True)


main()
