-- Cook's tapered panel: sheared at its right end, it bends, and near nu = 0.5 poor elements lock.
local u = units
local plane   = param { "plane", default = "stress", choices = { "stress", "strain" }, doc = "plane stress with nu = 1/3, or plane strain with nu" }
local nu      = param { "nu", default = 0.4999, doc = "Poisson's ratio in plane strain" }
local divide  = param { "divide", default = 16, doc = "cells along each side; others of about that size" }
local cells   = param { "cells", default = "quads", choices = { "quads", "voronoi", "triangles" }, doc = "shape of cells" }
local order   = param { "order", default = 1, doc = "order of the element" }
local kind    = param { "element", default = "vem", choices = { "vem", "none", "fem", "incompatible" },
                        doc = "virtual with its stabilisation or without any, finite, with incompatible modes" }
local elements = { vem = element.vem {}, none = element.vem { stabilisation = "none" },
                   fem = element.fem {}, incompatible = element.fem { incompatible = true } }
local stress = plane == "stress"
-- As published (E = 1 and a total shear of 1; E = 250 and a shear of 6.25), in GPa and MPa: deflections in mm.
local stuff = stress and material.elastic { E = 1*u.GPa, nu = 1/3 } or material.elastic { E = 250*u.GPa, nu = nu }
local shear = (stress and 1/16 or 6.25) * u.MPa

local size = 40*u.m / divide
local meshes = {
  quads = mesh.structured { cells = { divide, divide } },
  voronoi = mesh.voronoi { size = size, seed = 1 },
  triangles = mesh.gmsh { size = size },
}

return Scene {
  title = "Cook's panel",
  plane = plane,
  geometry = { panel = Polygon { {0,0}, {48,44,"end"}, {48,60}, {0,44,"wall"}, material = stuff } },
  mesh = meshes[cells],
  element = elements[kind], order = order,
  supports = { ["panel.wall"] = "xy" },
  stages = { Stage { "shear", tractions = { ["panel.end"] = Traction { y = shear } } } },
  outputs = {
    fields = { "displacement", "stress" },
    probes = { middle = { "displacement", at = {48,52} }, corner = { "displacement", at = {48,60} } },
  },
}
