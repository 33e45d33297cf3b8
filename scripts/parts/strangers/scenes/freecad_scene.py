# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Solids that FreeCAD turns, for scripts/strangers: freecad freecad_scene.py."""
import FreeCAD
import FreeCADGui
import Part
from PySide2 import QtCore

document = FreeCAD.newDocument()
SOLIDS = (Part.makeSphere(8), Part.makeCylinder(5, 16), Part.makeTorus(8, 3), Part.makeCone(8, 2, 14),
          Part.makeBox(12, 12, 12).cut(Part.makeCylinder(4, 12, FreeCAD.Vector(6, 6, 0))))
for i, solid in enumerate(SOLIDS):
    solid.translate(FreeCAD.Vector(24 * (i % 3), 24 * (i // 3), 0))
    part = document.addObject("Part::Feature", f"Solid{i}")
    part.Shape = solid
    part.ViewObject.Deviation = 5  # coarse
    part.ViewObject.AngularDeflection = 40
document.recompute()
view = FreeCADGui.activeDocument().activeView()
view.setAnimationEnabled(False)
view.viewIsometric()
FreeCADGui.SendMsgToActiveView("ViewFit")


def turn():
    view.setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 5).multiply(view.getCameraOrientation()))


timer = QtCore.QTimer()
timer.timeout.connect(turn)
timer.start(150)
