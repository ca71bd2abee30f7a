-- A cantilever under an end shear that is a parabola over its depth: Timoshenko and Goodier's plane solution
-- (Theory of Elasticity, art. 21), cubic in the displacement. The root follows it, the end carries its tractions.
local u = units
local order = param { "order", default = 2, doc = "order of the element" }
local divide = param { "divide", default = 4, doc = "cells over the depth" }
local cells = param { "mesh", default = "quads", choices = { "quads", "voronoi" }, doc = "shape of cells" }
local L, D, P, E, nu = 48, 12, 1000e3, 30e9, 0.3   -- plane stress; the load points down
local I = D^3/12
local function displacement(x, y)
  return P*y/(6*E*I) * ((6*L - 3*x)*x + (2 + nu)*(y^2 - D^2/4)),
         -P/(6*E*I) * (3*nu*y^2*(L - x) + (4 + 5*nu)*D^2*x/4 + (3*L - x)*x^2)
end
local function shear(x, y) return -P/(2*I) * (D^2/4 - y^2) end
local function stress(x, y) return P*(L - x)*y/I, 0, shear(x, y) end
local stuff = material.elastic { E = E*u.Pa, nu = nu }
local root = Support {
  ux = function(x, y) return (displacement(x, y)) end,
  uy = function(x, y) return (select(2, displacement(x, y))) end,
}

return Scene {
  title = "Timoshenko's cantilever", plane = "stress",
  geometry = { beam = Polygon { {0,-6,"low"}, {48,-6,"end"}, {48,6,"high"}, {0,6,"root"}, material = stuff } },
  mesh = cells == "quads" and mesh.structured { cells = { 4*divide, divide } } or mesh.voronoi { size = 12*u.m/divide, seed = 3 },
  element = "vem", order = order,
  supports = { ["beam.root"] = root },
  stages = { Stage { "shear", tractions = { ["beam.end"] = Traction { y = shear } } } },
  outputs = {
    fields = { "displacement", "stress" },
    probes = { tip = { "displacement", at = {48,0} } },
    exact = { beam = Exact { displacement = displacement, stress = stress } },
  },
}
