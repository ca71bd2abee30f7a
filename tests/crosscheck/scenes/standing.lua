-- A block that stands fixed on its whole base under even pressure: no upright line through it carries any force.
local u = units
local kind  = param { "mesh", default = "voronoi", choices = { "voronoi", "quads" }, doc = "shape of cells" }
local order = param { "order", default = 1, doc = "order of the element" }
local stuff = material.elastic { E = 10*u.GPa, nu = 0 }
local meshes = { voronoi = mesh.voronoi { size = 0.9, seed = 4 }, quads = mesh.structured { cells = {10,5} } }
return Scene {
  title = "Standing block",
  plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {10,5}, material = stuff } },
  mesh = meshes[kind], element = "vem", order = order,
  supports = { ["block.bottom"] = "xy" },
  stages = { Stage { "pressure", pressures = { ["block.top"] = 1*u.MPa } } },
  outputs = {
    fields = { "displacement" },
    sections = {
      through  = Section { {3.1,0}, {3.1,5} },
      on_edges = Section { {4,0}, {4,5} },
      downward = Section { {4,5}, {4,0} },
      near     = Section { {0.2,0}, {0.2,5} },
      slanted  = Section { {4,0}, {5,5} },
    },
  },
}
