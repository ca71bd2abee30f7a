-- expect 13: joints.fault.friction.dilation: opens the lips by more than the shear pays for
-- expect: sliding would give energy back
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock on a joint",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { path = { {0,2}, {10,2} },
      friction = contact.lua_friction { strength = function(pressure) return 0.5*pressure end,
        dilation = function(pressure, path) return 0.6*path end } },
  },
  mesh = mesh.structured { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
