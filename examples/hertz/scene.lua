-- Hertz: an elastic disc pressed onto a block, half of both. Source paper's Example 2.
local u = units
local loading = param { "loading", default = "flat_top", choices = { "flat_top", "pole" },
                        doc = "a lower half disc under an even load, or a full disc under a load near its pole" }
local cells   = param { "cells", default = 600, choices = { 389, 600, 1155 }, doc = "about so many, as in the paper" }
local shape   = param { "shape", default = "quads", choices = { "quads", "triangles" }, doc = "of the cells" }
local order   = param { "order", default = 1, choices = { 1, 2, 3 }, doc = "of the virtual elements" }
local pairing = param { "pairing", default = "mortar", choices = { "mortar", "node_insertion", "node_to_segment" },
                        doc = "how the bodies find each other" }
local enforce = param { "enforce", default = "lagrange", choices = { "lagrange", "penalty" },
                        doc = "how penetration is prevented" }
local factor  = param { "factor", default = 100, doc = "of the penalty" }

local R, F = 10*u.m, 100*u.N/u.m   -- the load on half of the model
local soft = material.elastic { E = 1000*u.Pa, nu = 0.3 }
local hard = material.elastic { E = 1e6*u.Pa, nu = 0.3 }

-- Cells at the contact, elsewhere, and how fast they grow between.
local sizes = {
  flat_top = { [389] = { 0.19, 1.6, 0.33 }, [600] = { 0.145, 1.45, 0.235 }, [1155] = { 0.095, 1.2, 0.187 } },
  pole     = { [389] = { 0.2, 1.95, 0.39 }, [600] = { 0.15, 1.7, 0.26 }, [1155] = { 0.1, 1.3, 0.19 } },
}
local fine, coarse, grading = table.unpack(sizes[loading][cells])
fine = param { "fine", default = fine*u.m, doc = "size of cells at the contact" }

-- The full disc is loaded on a facet of 5° at its upper pole.
local facet = { x = R*math.sin(math.rad(5)), y = 2*R + R*math.cos(math.rad(5)) }
local discs = {
  flat_top = Polygon { {0,R,"rim", arc = Arc { center = {0,2*R} }},
                       {R,2*R,"load"}, {0,2*R,"axis"}, material = soft },
  pole = Polygon { {0,R,"rim", arc = Arc { through = {R,2*R} }},
                   {facet.x,facet.y,"load"}, {0,facet.y,"axis"}, material = soft },
}
local width = loading == "pole" and facet.x or R
local slaves = { mortar = "block", node_insertion = "disc", node_to_segment = "disc" }
local enforcements = { lagrange = contact.lagrange {}, penalty = contact.penalty { factor = factor } }

return Scene {
  title = "Hertz: a disc on a block", plane = "strain",
  geometry = {
    disc = discs[loading],
    block = Rectangle { from = {0,0}, to = {10,10}, names = { "bottom", "right", "top", "axis" }, material = hard },
  },
  joints = {
    touch = Joint { faces = { "disc.rim", "block.top" }, friction = "none",
                    pairing = pairing, slave = slaves[pairing], enforce = enforcements[enforce] },
  },
  mesh = mesh.gmsh { size = coarse, cells = shape, grading = grading,
                     refine = { { at = {0,R}, size = fine, radius = 1.6*u.m } } },
  element = "vem", order = order,
  supports = { ["block.bottom"] = "xy", ["block.axis"] = "x", ["disc.axis"] = "x" },
  stages = { Stage { "press", tractions = { ["disc.load"] = { y = -F/width } } } },
  outputs = { fields = { "displacement", "stress" } },
}
