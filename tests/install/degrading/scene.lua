-- The same law twice: written here, and as a module of its own outside Ashlar's tree.
local u = units
local law   = param { "law", default = "module", choices = { "module", "lua" }, doc = "which of the two" }
local plane = param { "plane", default = "strain", doc = "strain or stress" }
local K, G, half = 20*u.MPa, 10*u.MPa, 1e-3

local function degrading(strain, state, p)
  local volume = strain.xx + strain.yy + strain.zz
  local xx, yy, zz, xy = strain.xx - volume/3, strain.yy - volume/3, strain.zz - volume/3, strain.xy/2
  local kappa = math.max(state[1], math.sqrt(2 * (xx^2 + yy^2 + zz^2 + 2*xy^2)))
  local g = p.G / (1 + kappa/p.half)
  return { xx = p.K*volume + 2*g*xx, yy = p.K*volume + 2*g*yy, zz = p.K*volume + 2*g*zz, xy = 2*g*xy }, { kappa }
end
local soil = law == "module" and material.degrading { K = K, G = G, half = half }
             or material.lua { stress = degrading, variables = 1, parameters = { K = 20e6, G = 10e6, half = half } }

return Scene {
  title = "Soil that softens under a load",
  plane = plane,
  geometry = { soil = Polygon { {0,0,"bottom"}, {2,0}, {2,1}, {1,1,"load"}, {0,1}, material = soil } },
  mesh = mesh.structured { size = 0.25 },
  supports = { ["soil.bottom"] = "xy" },
  stages = {
    Stage { "load", pressures = { ["soil.load"] = 20*u.kPa } },
    Stage { "half of it", pressures = { ["soil.load"] = 10*u.kPa } },
  },
  outputs = { fields = { "displacement" }, probes = { corner = { "displacement", at = {0,1} } } },
}
