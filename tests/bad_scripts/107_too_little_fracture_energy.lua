-- expect 13: fracture_energy: must exceed tensile_strength^2/(2 stiffness) = 50 N/m
-- expect: a stiffness above
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock on a joint",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { path = { {0,2}, {10,2} },
      normal_law = contact.cohesive { stiffness = 10*u.GPa/u.m, tensile_strength = 1*u.MPa,
        fracture_energy = 49*u.N/u.m }, friction = "none" },
  },
  mesh = mesh.structured { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
