-- The same friction twice: written here, and as a module of its own outside Ashlar's tree. At 4 MPa it starts at
-- 2 MPa; 4 mm of slip leave a third.
local u = units
local law = param { "law", default = "module", choices = { "module", "lua" }, doc = "which of the two" }

local function power(pressure, path, p)
  return p.A * (pressure/1e6)^p.b / (1 + path/p.wear)
end
local rough = law == "module" and contact.power { A = 1*u.MPa, b = 0.5, wear = 2*u.mm }
              or contact.lua_friction { strength = power, parameters = { A = 1e6, b = 0.5, wear = 2e-3 } }

return Drive {
  title = "Friction as a power of the pressure",
  joint = { friction = rough },
  steps = 20,
  path = { { pressure = 4*u.MPa }, { slip = 4*u.mm } },
}
