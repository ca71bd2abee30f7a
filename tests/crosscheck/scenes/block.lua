-- A block under uniform pressure, whole or cut across by a joint: both deform uniformly, and the joint adds its
-- penalty's penetration.
local u = units
local kind  = param { "mesh", default = "voronoi", choices = { "voronoi", "quads" }, doc = "shape of cells" }
local joint = param { "joint", default = false, doc = "cut the block across" }
local stuff = material.elastic { E = 10*u.GPa, nu = 0.3 }
local meshes = { voronoi = mesh.voronoi { cells = 60, seed = 3 }, quads = mesh.gmsh { size = 0.5, cells = "quads" } }
local cut = Joint { path = { {0,1}, {4,1} }, sides = { "upper", "lower" }, friction = "none",
                    enforce = contact.penalty { stiffness = 2*u.GPa/u.m } }

return Scene {
  title = "Block under pressure",
  plane = "strain",
  geometry = {
    block = Polygon { {0,0,"bottom"}, {4,0,"right"}, {4,3,"top"}, {0,3,"left"}, material = stuff },
  },
  joints = joint and { cut = cut } or {},
  mesh = meshes[kind],
  element = "vem",
  supports = { ["block.bottom"] = "y", ["block.left"] = "x" },
  stages = { Stage { "pressure", pressures = { ["block.top"] = 1*u.MPa } } },
  outputs = { probes = { corner = { "displacement", at = {4,3} } } },
}
