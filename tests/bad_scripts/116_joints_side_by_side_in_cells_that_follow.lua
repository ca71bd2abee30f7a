-- expect 8: joints 'fault' and 'vein' are 0.005 mm apart around (
-- expect: where the size asked for is 500 mm: the mesh cannot tell them apart
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene { title = "A block of rock", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { friction = "none", path = { {0,2}, {10,2} } },
    vein = Joint { friction = "none", path = { {0,2.000005}, {10,2.000005} } } },
  mesh = mesh.voronoi { size = 0.5 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
