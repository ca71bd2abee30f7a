-- A block of soil on a smooth base under a pressure, its sides free: it carries 2 c cos φ/(1 − sin φ) and no more.
local u = units
local order    = param { "order", default = 1, doc = "order of the element" }
local pressure = param { "pressure", default = 10*u.kPa, doc = "on its top" }
local cohesion = param { "cohesion", default = 10*u.kPa, doc = "of the soil" }
local soil = material.mohr_coulomb { E = 10*u.MPa, nu = 0.3, cohesion = cohesion, friction = 30*u.deg, dilation = 10*u.deg }

return Scene {
  title = "A pressed block of soil", plane = "strain",
  geometry = { soil = Rectangle { from = {0,0}, to = {1,1}, material = soil } },
  mesh = mesh.voronoi { cells = 30, seed = 4 }, order = order,
  supports = { ["soil.bottom"] = "y", ["soil.left"] = "x" },
  stages = { Stage { "half", pressures = { ["soil.top"] = 0.5*pressure } },
             Stage { "whole", pressures = { ["soil.top"] = pressure } } },
  outputs = { fields = { "displacement", "stress" } },
}
