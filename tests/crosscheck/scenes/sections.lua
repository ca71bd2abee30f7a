-- A beam with weight, pressure and end traction, cut by lines of all kinds: N, V and M follow from statics.
local u = units
local kind    = param { "mesh", default = "voronoi", choices = { "voronoi", "quads", "triangles" }, doc = "shape of cells" }
local element = param { "element", default = "vem", choices = { "vem", "fem" }, doc = "element" }
local order   = param { "order", default = 1, doc = "order of the element" }
local yields  = param { "yields", default = false, doc = "a law that may yield" }
local weight = 30*u.kN/u.m^3
local stuff = yields and material.mohr_coulomb { E = 10*u.GPa, nu = 0.3, cohesion = 50*u.MPa, friction = 30*u.deg,
                                                 dilation = 0, unit_weight = weight }
              or material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = weight }
local meshes = { voronoi = mesh.voronoi { size = 0.6, seed = 5 }, quads = mesh.structured { cells = {20,4} },
                 triangles = mesh.gmsh { size = 0.5, cells = "triangles" } }

return Scene {
  title = "Sections of a beam",
  plane = "strain",
  thickness = 0.5,
  geometry = {
    beam = Polygon { {0,0,"bottom"}, {10,0,"right"}, {10,2,"top"}, {0,2,"left"}, material = stuff },
  },
  mesh = meshes[kind],
  element = element, order = order,
  supports = { ["beam.left"] = "xy" },
  stages = {
    Stage { "load", gravity = true, pressures = { ["beam.top"] = 80*u.kPa },
            tractions = { ["beam.right"] = { x = 200*u.kPa, y = -60*u.kPa } } },
  },
  outputs = {
    fields = { "displacement" },
    sections = {
      upright  = Section { {3.37,0}, {3.37,2} },
      turned   = Section { {3.37,2}, {3.37,0} },
      beyond   = Section { {3.37,-1}, {3.37,7} },
      on_edges = Section { {5,0}, {5,2} },
      inclined = Section { {3,0}, {4.5,2} },
      kinked   = Section { {3,0}, {4.1,1.05}, {3.2,2} },
      support  = Section { {0,0}, {0,2} },
      edge     = Section { edge = "beam.left" },
      loaded   = Section { edge = "beam.right" },
      part     = Section { {3.37,0}, {3.37,1} },
    },
  },
}
