-- expect 12: stages[1]: nothing holds 'base' in stage 'self-weight': it can slide in x
-- expect: add to supports, for example ["base.bottom"] = "xy"
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { base = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["base.bottom"] = "y" },
  stages = { Stage { "self-weight", gravity = true } },
}
