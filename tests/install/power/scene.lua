-- A block pushed along its base until the joint slips at the heel, with the friction written here or as a module.
local u = units
local law = param { "law", default = "module", choices = { "module", "lua" }, doc = "which of the two" }

local function power(pressure, path, p)
  return p.A * (pressure/1e6)^p.b / (1 + path/p.wear)
end
local rough = law == "module" and contact.power { A = 0.2*u.MPa, b = 0.5, wear = 2*u.mm }
              or contact.lua_friction { strength = power, parameters = { A = 0.2e6, b = 0.5, wear = 2e-3 } }
local rock = material.elastic { E = 1*u.GPa, nu = 0.25, unit_weight = 24*u.kN/u.m^3 }

return Scene {
  title = "A block on rough rock",
  plane = "strain",
  geometry = {
    base  = Rectangle { from = {0,0}, to = {10,3}, material = rock },
    block = Rectangle { from = {2,3}, to = {8,6}, material = rock },
  },
  joints = { bed = Joint { between = { "base", "block" }, friction = rough } },
  mesh = mesh.structured { size = 0.5 },
  supports = { ["base.bottom"] = "xy" },
  stages = {
    Stage { "weight", gravity = true },
    Stage { "push", pressures = { ["block.left"] = 75*u.kPa } },
  },
  outputs = { probes = { corner = { "displacement", at = {2,6} } } },
}
