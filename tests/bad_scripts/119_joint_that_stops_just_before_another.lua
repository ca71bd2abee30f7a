-- expect 9: 'vein' are 1 mm apart around (5, 2.001)
-- expect: a joint may also end on the other
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene { title = "A block of rock", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { friction = "none", path = { {3,2}, {7,2} } },
    vein = Joint { friction = "none", path = { {5,4}, {5,2.001} } } },
  mesh = mesh.structured { size = 0.5 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
