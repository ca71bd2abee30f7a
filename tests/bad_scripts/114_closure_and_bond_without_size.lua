-- expect 12: joints.fault.normal_law.greatest_closure: must be above 0 m
-- expect 14: joints.bed.normal_law.tensile_strength: is missing: a number (Pa)
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock on two joints",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { path = { {0,2}, {10,2} }, friction = "none",
      normal_law = contact.barton_bandis_closure { stiffness = 10*u.GPa/u.m, greatest_closure = 0*u.mm } },
    bed = Joint { path = { {0,3}, {10,3} },
      normal_law = contact.tension_cut_off {}, friction = contact.barton_bandis { JRC = 5, JCS = 1e8, residual_angle = 30*u.deg } },
  },
  mesh = mesh.structured { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
