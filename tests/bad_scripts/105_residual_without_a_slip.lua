-- expect 11: joints.fault.friction: does not say the slip over which the strength falls
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock on a joint",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { path = { {0,2}, {10,2} },
      friction = contact.coulomb { friction_angle = 30*u.deg, residual_friction_angle = 25*u.deg } },
  },
  mesh = mesh.structured { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
