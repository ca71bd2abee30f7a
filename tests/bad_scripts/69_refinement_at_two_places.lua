-- expect 11: at and joint are both said
-- expect 11: mesh.refine[2]: needs exactly one of at, point and joint
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { path = { {2,5}, {4,3} }, friction = "none" } },
  mesh = mesh.voronoi { size = 1, refine = { { at = {2,5}, joint = "fault", size = 0.1 }, { size = 0.1 } } },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { probes = { crest = { at = {5, 5} } } },
}
