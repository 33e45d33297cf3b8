-- SPDX-FileCopyrightText: 2026 The glark authors
-- SPDX-License-Identifier: MIT
-- Shapes, text, a mesh and a canvas in LÖVE, for scripts/strangers.
local frame, canvas, mesh = 0, nil, nil

function love.load()
  love.window.setMode(320, 240)
  canvas = love.graphics.newCanvas(80, 80)
  mesh = love.graphics.newMesh({ { 0, 0, 0, 0, 1, 0, 0 }, { 90, 0, 1, 0, 0, 1, 0 }, { 45, 80, .5, 1, 0, 0, 1 } }, "fan")
end

function love.draw()
  frame = frame + 1
  love.graphics.setCanvas(canvas)
  love.graphics.clear(.1, .1, .2)
  love.graphics.circle("fill", 40, 40, 30, 9)
  love.graphics.setCanvas()
  love.graphics.setColor(.9, .5, .2)
  love.graphics.polygon("fill", 20, 20, 120, 30, 90, 110)
  love.graphics.setColor(1, 1, 1)
  love.graphics.draw(canvas, 200, 40, frame * .05, 1, 1, 40, 40)
  love.graphics.draw(mesh, 40, 140)
  love.graphics.ellipse("line", 220, 180, 60, 30)
  love.graphics.print("LOVE " .. frame, 150, 120, .2, 2, 2)
end
