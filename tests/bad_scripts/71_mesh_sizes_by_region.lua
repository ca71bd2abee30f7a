-- expect 12: there is no region 'rok'
-- expect: did you mean 'rock'?
-- expect 12: must be above 0 m, got 0 m
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { path = { {2,5}, {4,3} }, friction = "none" } },
  mesh = mesh.voronoi { size = { rok = 0.5, rock = 0 } },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { probes = { crest = { at = {5, 5} } } },
}
