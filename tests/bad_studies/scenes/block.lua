-- A block under its own weight; `tall` adds a stage, `mark` a probe.
local cells = param { "cells", default = 16, min = 4 }
local kind  = param { "mesh", default = "squares", choices = { "squares", "voronoi" } }
local height = param { "height", default = 2*units.m }
local tall  = param { "tall", default = false }
local mark  = param { "mark", default = true }
local rock  = material.elastic { E = 1e9, nu = 0, unit_weight = 24e3 }
local meshes = { squares = mesh.structured { size = (height*1*units.m/cells)^0.5 }, voronoi = mesh.voronoi { cells = cells } }
local stages = { Stage { "weight", gravity = true } }
if tall then stages[2] = Stage { "half", gravity = 5 } end
return Scene {
  title = "A block", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {1*units.m, height}, material = rock } },
  mesh = meshes[kind], element = "vem", supports = { ["block.bottom"] = "xy" },
  stages = stages,
  outputs = { pictures = false, probes = { top = { "displacement", at = {0, height} },
    side = mark and { "displacement", "stress", at = {1, height} } or nil } },
}
