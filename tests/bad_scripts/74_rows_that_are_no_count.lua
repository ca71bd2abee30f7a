-- expect 11: must be a whole number
-- expect 11: must be at least 0.0001
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { path = { {2,5}, {4,3} }, friction = "none" } },
  mesh = mesh.structured { size = 1, regions = { rock = { cells = {4, 0.5}, grading = {0, 1} } } },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { probes = { crest = { at = {5, 5} } } },
}
