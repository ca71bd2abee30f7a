-- Soil behind a wall that leans into it: weight, then yielding. Lengths times m, stresses times pa: other units.
local m  = param { "m", default = 1, doc = "what the unit of length is multiplied by" }
local pa = param { "pa", default = 1, doc = "what the unit of stress is multiplied by" }
local order = param { "order", default = 1, doc = "order of the element" }
local dilation = param { "dilation", default = 0.1, doc = "angle of dilation; 0.5, the friction, is associated flow" }
local soil = material.mohr_coulomb {
  E = 10e6*pa, nu = 0.3, unit_weight = 20e3*pa/m, cohesion = 5e3*pa, friction = 0.5, dilation = dilation,
}
local function leaning(_, y) return 0.004*y end

return Scene {
  title = "Soil pushed by a wall", plane = "strain",
  geometry = { soil = Rectangle { from = {0,0}, to = {4*m,2*m}, material = soil } },
  mesh = mesh.structured { cells = {8,4}, grading = 2 }, order = order,
  supports = { ["soil.bottom"] = "xy", ["soil.right"] = "x", ["soil.left"] = "x" },
  stages = {
    Stage { "weight", gravity = true },
    Stage { "push", supports = { ["soil.bottom"] = "xy", ["soil.right"] = "x", ["soil.left"] = { ux = leaning } } },
  },
  outputs = { fields = { "displacement", "stress" }, probes = { top = { "displacement", at = {4*m,2*m} } } },
}
