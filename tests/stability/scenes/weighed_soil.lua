-- A bank of soil, free on one side, whose weight grows in steps, vanishes in steps and comes back.
local u = units
local order = param { "order", default = 1, doc = "order of the element" }
local steps = param { "steps", default = 4, doc = "stages in which the weight grows" }
local least = param { "least", default = 0, doc = "share of the weight that stays before it comes back" }
local yields = param { "yields", default = true, doc = "false: elastic" }
local moduli = { E = 10*u.MPa, nu = 0.3, density = 2000*u.kg/u.m^3 }
if yields then
  moduli.cohesion, moduli.friction, moduli.dilation = 8*u.kPa, 25*u.deg, 5*u.deg
end
local soil = (yields and material.mohr_coulomb or material.elastic)(moduli)

local stages = {}
local function weigh(name, share) stages[#stages + 1] = Stage { name, gravity = share*9.81 } end
for i = 1, steps do weigh(i == steps and "up" or "up " .. i, i/steps) end
for i = steps - 1, 0, -1 do weigh(i == 0 and "down" or "down " .. i, least + (1 - least)*i/steps) end
for i = 1, steps do weigh(i == steps and "again" or "again " .. i, least + (1 - least)*i/steps) end

return Scene {
  title = "A bank of soil", plane = "strain",
  geometry = { soil = Rectangle { from = {0,0}, to = {2,2}, material = soil } },
  mesh = mesh.voronoi { cells = 40, seed = 3 }, order = order,
  supports = { ["soil.bottom"] = "xy", ["soil.left"] = "x" },
  stages = stages,
  outputs = { fields = { "displacement", "stress" } },
}
