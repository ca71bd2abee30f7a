-- A smooth strip footing on weightless Tresca soil, half of it: it carries (2 + π) c whatever the stiffness.
local u = units
local kind    = param { "kind", default = "vem", choices = { "vem", "fem" }, doc = "kind of element" }
local order   = param { "order", default = 2, doc = "its order" }
local cells   = param { "cells", default = "voronoi", choices = { "voronoi", "quads", "triangles" }, doc = "shape of cells" }
local size    = param { "size", default = 0.25*u.m, doc = "of the cells" }
local fine    = param { "fine", default = 0.05*u.m, doc = "of the cells at the footing's edge" }
local push    = param { "push", default = 0.02*u.m, doc = "way of the footing" }
local elastic_rest = param { "stabilised", default = false, doc = "with the stabilisation of the elastic law" }
local soil = material.mohr_coulomb { E = 10*u.MPa, nu = 0.45, cohesion = 10*u.kPa, friction = 0*u.deg, dilation = 0*u.deg }
local refine = { { at = {0.5,2.5}, size = fine, radius = 0.1 } }
local meshes = {
  voronoi = function() return mesh.voronoi { size = size, refine = refine, seed = 2 } end,
  quads = function() return mesh.gmsh { size = size, cells = "quads", refine = refine } end,
  triangles = function() return mesh.gmsh { size = size, refine = refine } end,
}
local choice = kind
if elastic_rest then choice = element.vem { stabilisation = "bending" } end

return Scene {
  title = "A strip footing", plane = "strain",
  geometry = {
    soil = Polygon { {0,0,"bottom"}, {4,0,"right"}, {4,2.5,"ground"}, {0.5,2.5,"footing"}, {0,2.5,"left"}, material = soil },
  },
  mesh = meshes[cells](),
  element = choice, order = order,
  supports = { ["soil.bottom"] = "xy", ["soil.right"] = "x", ["soil.left"] = "x", footing = Support { edge = "soil.footing", uy = -push } },
  stages = { Stage { "push" } },
  outputs = { fields = { "displacement", "stress" } },
}
