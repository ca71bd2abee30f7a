-- expect 9: joints 'fault' and 'vein' are 5 mm apart around (
-- expect: where the mesh has edges of 500 mm: the mesh cannot tell them apart
-- expect: smaller cells there, of at most 50 mm, or one joint in place of both
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene { title = "A block of rock", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { friction = "none", path = { {3,2}, {7,2} } },
    vein = Joint { friction = "none", path = { {3,2.005}, {7,2.005} } } },
  mesh = mesh.structured { size = 0.5 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
