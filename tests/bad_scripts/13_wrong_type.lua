-- expect 6: must be "strain", "stress" or "axisymmetric", got 3
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = 3,
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
