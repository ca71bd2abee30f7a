-- expect 8: joint 'fault' and edge 'rock.top' are 10 mm apart around (
-- expect: smaller cells there, of at most 
-- expect: or move the joint
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene { title = "A block of rock", plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = { fault = Joint { friction = "none", path = { {3,4.99}, {7,4.99} } } },
  mesh = mesh.gmsh { size = 0.5 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
