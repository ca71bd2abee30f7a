-- Two stacked rectangles pressed together: the pressure along the interface. Source paper's Example 3.
local u = units
local shape = param { "shape", default = "voronoi", choices = { "voronoi", "quads", "triangles" }, doc = "of the cells" }
local cells = param { "cells", default = 500, doc = "number of cells of both bodies together, about" }
local match = param { "match", default = true, doc = "one mesh that the interface splits; else each body is meshed alone" }
local ratio = param { "ratio", default = 2^0.5, doc = "size of the upper cells over that of the lower, if they do not match" }
local pairing = param { "pairing", default = "mortar",
                        choices = { "mortar", "node_insertion", "node_to_segment", "two_passes" },
                        doc = "how the lips find each other" }
local order = param { "order", default = 1, choices = { 1, 2 }, doc = "of the virtual elements" }

local stuff = material.elastic { E = 1*u.GPa, nu = 0.3 }
local width, height = 2*u.m, 1*u.m   -- of each rectangle; the paper does not tell

-- Sizes that keep the number of cells: lower^2 = (1 + 1/ratio^2) / 2 of the matching size's square.
local size = (2*width*height/cells)^0.5
local lower = match and size or size*((1 + ratio^-2)/2)^0.5
local upper = match and size or lower*ratio
-- Equilateral triangles of this side have the area of a square of the given one.
local side = 2/3^0.25
local function columns(wished) return { math.max(1, (width/wished + 0.5)//1), math.max(1, (height/wished + 0.5)//1) } end
local meshes = {
  voronoi = mesh.voronoi { size = { upper = upper, lower = lower }, seed = 3 },
  triangles = mesh.gmsh { size = { upper = side*upper, lower = side*lower } },
  quads = mesh.structured { regions = { upper = { cells = columns(upper) }, lower = { cells = columns(lower) } } },
}
local pairings = {
  mortar = contact.mortar {}, node_insertion = contact.node_insertion {},
  node_to_segment = contact.node_to_segment {}, two_passes = contact.node_to_segment { passes = 2 },
}
local lips = match and { between = { "upper", "lower" } } or { faces = { "upper.face", "lower.face" } }
lips.friction, lips.enforce, lips.pairing = "none", contact.lagrange {}, pairings[pairing]

return Scene {
  title = "Two rectangles, one on the other",
  plane = "strain",
  geometry = {
    lower = Rectangle { from = {0,0}, to = {width,height}, names = { "bottom", "right", "face", "left" }, material = stuff },
    upper = Rectangle { from = {0,height}, to = {width,2*height}, names = { "face", "right", "top", "left" }, material = stuff },
  },
  joints = { interface = Joint(lips) },
  mesh = meshes[shape], element = "vem", order = order,
  supports = { ["lower.bottom"] = "xy", top = Support { edge = "upper.top", ux = 0, uy = -0.1*u.m } },
  stages = { Stage { "press" } },
  outputs = { fields = { "displacement", "stress" } },
}
