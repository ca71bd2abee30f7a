-- A block whose sides follow a smooth field in equilibrium without body forces:
--   u = grad(e^x sin y) + pure bending.
local u = units
local kind  = param { "mesh", default = "voronoi", choices = { "voronoi", "quads", "structured" }, doc = "shape of cells" }
local cells = param { "cells", default = 200, doc = "number of cells" }
local order = param { "order", default = 1, doc = "order of the element" }
local nu = 0.3
local stuff = material.elastic { E = 1*u.GPa, nu = nu }
local meshes = {
  voronoi = mesh.voronoi { cells = cells, seed = 5 },
  structured = mesh.structured { size = cells^-0.5 },
  quads   = mesh.gmsh { cells = "quads", size = cells^-0.5 },
}

local function ux(x, y) return math.exp(x)*math.sin(y) + x*y end
local function uy(x, y) return math.exp(x)*math.cos(y) - x^2/2 - nu/(1 - nu)*y^2/2 end
local G = 1e9 / (2*(1 + nu))
local function stress(x, y)
  local s, c = math.exp(x)*math.sin(y), math.exp(x)*math.cos(y)
  return 2*G*(s + y/(1 - nu)), -2*G*s, 2*G*c
end
local led = Support { ux = ux, uy = uy }

return Scene {
  title = "A smooth field",
  plane = "strain",
  geometry = { block = Polygon { {0,0,"bottom"}, {1,0,"right"}, {1,1,"top"}, {0,1,"left"}, material = stuff } },
  mesh = meshes[kind],
  element = "vem", order = order,
  supports = { ["block.bottom"] = led, ["block.right"] = led, ["block.top"] = led, ["block.left"] = led },
  stages = { Stage { "led" } },
  outputs = {
    fields = { "displacement", "stress", "stress_nodes" },
    exact = { smooth = Exact { displacement = function(x, y) return ux(x, y), uy(x, y) end, stress = stress } },
  },
}
