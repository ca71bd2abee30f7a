-- expect 11: must be two of: a whole number
-- expect 11: must be above 0 m, got -1 m
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { path = { {2,5}, {4,3} }, friction = "none" } },
  mesh = mesh.structured { cells = {4}, regions = { rock = { size = -1 } } },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { probes = { crest = { at = {5, 5} } } },
}
