-- Cantilever of two quadrilaterals under an end moment: what does a distorted mesh cost?
local u = units
local distortion = param { "distortion", default = 0, doc = "2d/b: how far the inner edge leans, from 0 to below 5" }
local order = param { "order", default = 1, doc = "order of the element, 1 to 3" }
local kind = param { "element", default = "vem", choices = { "vem", "fem", "incompatible" }, doc = "virtual or finite element" }
local rest = param { "stabilisation", default = "bending", choices = { "bending", "shear", "diagonal", "none" }, doc = "of virtual elements" }
local elements = { vem = element.vem { stabilisation = rest }, fem = element.fem {}, incompatible = element.fem { incompatible = true } }

local length, depth = 40*u.m, 8*u.m
local moment = 16*u.MN*u.m
local stuff = material.elastic { E = 1000*u.MPa, nu = 0 }

local lean = distortion * depth / 2   -- d: the inner edge runs from L/2 + d up to L/2 - d
local foot, head = length/2 + lean, length/2 - lean

return Scene {
  title = "Cantilever under an end moment, two cells",
  plane = "strain",
  geometry = {
    left  = Polygon { {0,0}, {foot,0}, {head,depth}, {0,depth,"wall"}, material = stuff },
    right = Polygon { {foot,0}, {length,0}, {length,depth}, {head,depth}, material = stuff },
  },
  mesh = mesh.structured { cells = {1,1} },
  element = elements[kind], order = order,
  supports = {   -- only what pure bending leaves at rest
    ["left.wall"] = "x",
    corner = Support { at = {0,0}, fix = "y" },
  },
  stages = {
    Stage { "moment", couples = { Couple { between = { {length,0}, {length,depth} }, moment = moment } } },
  },
  outputs = { probes = { tip = { "displacement", at = {length,depth} } } },
}
