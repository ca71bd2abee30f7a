-- expect 7: unit_weight and density are both said
-- expect: say at most one of unit_weight and density
-- found by check
local u = units
local rock = material.elastic {
  E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3,
  density = 2400*u.kg/u.m^3,
}
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
