-- A block of soil on a smooth base, pressed from above by a smooth plate or by a pressure, its sides free: uniform
-- stress, and plastic flow once the stress reaches 2 c cos φ/(1 − sin φ).
local u = units
local element  = param { "element", default = "vem", choices = { "vem", "fem" }, doc = "kind of element" }
local order    = param { "order", default = 1, doc = "its order" }
local dilation = param { "dilation", default = 0*u.deg, doc = "angle of dilation; 30 degrees is associated flow" }
local press    = param { "press", default = 0.02*u.m, doc = "way of the plate" }
local pressure = param { "pressure", default = 0*u.Pa, doc = "instead of the plate" }
local soil = material.mohr_coulomb {
  E = 10*u.MPa, nu = 0.3, cohesion = 10*u.kPa, friction = 30*u.deg, dilation = dilation,
}
local supports = { ["soil.bottom"] = "y", ["soil.left"] = "x" }
local stage = Stage { "press" }
if pressure > 0*u.Pa then
  stage.pressures = { ["soil.top"] = pressure }
else
  supports["soil.top"] = { uy = -press }
end

return Scene {
  title = "A pressed block of soil", plane = "strain",
  geometry = { soil = Rectangle { from = {0,0}, to = {1,1}, material = soil } },
  mesh = element == "vem" and mesh.voronoi { cells = 30, seed = 4 } or mesh.structured { size = 0.25 },
  element = element, order = order,
  supports = supports,
  stages = { stage },
  outputs = { fields = { "displacement", "stress" }, probes = { corner = { "displacement", at = {1,1} } } },
}
