-- expect 6: joints.fault.friction.strength: the function
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
local function power(pressure, path, p)
  return p.A * pressure^0.7
end
return Scene {
  title = "A block of rock on a joint",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  joints = {
    fault = Joint { path = { {0,2}, {10,2} },
      friction = contact.lua_friction { strength = power } },
  },
  mesh = mesh.structured { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
