-- expect 16: there is no picture 'syyy'
-- expect: did you mean 'syy'?
-- expect 16: there is no stage 'self weight'
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.structured { cells = {4,2} },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = {
    pictures = { "syyy", "von_mises" }, picture_stages = { "self weight" },
  },
}
