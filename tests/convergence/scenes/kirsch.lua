-- A quarter of a wide plate with a round hole of radius 1, pulled along x: the sides of the piece carry the stresses
-- that Kirsch's solution of the infinite plate has there.
local u = units
local h    = param { "h", default = 0.2*u.m, doc = "size of cells at the hole" }
local kind = param { "mesh", default = "voronoi", choices = { "voronoi", "quads" }, doc = "shape of cells" }
local steel = material.elastic { E = 10*u.GPa, nu = 0.3 }
local pull = 1*u.MPa

local function kirsch(x, y)
  local s, t, p2 = pull/u.Pa, math.atan(y, x), 1/(x*x + y*y)
  local c2, c4, s2, s4 = math.cos(2*t), math.cos(4*t), math.sin(2*t), math.sin(4*t)
  return s*(1 - p2*(1.5*c2 + c4) + 1.5*p2^2*c4),
         s*(-p2*(0.5*c2 - c4) - 1.5*p2^2*c4),
         s*(-p2*(0.5*s2 + s4) + 1.5*p2^2*s4)
end
local function xx(x, y) local a = kirsch(x, y) return a*u.Pa end
local function yy(x, y) local _, b = kirsch(x, y) return b*u.Pa end
local function xy(x, y) local _, _, c = kirsch(x, y) return c*u.Pa end

local near_hole = { { at = {0.7,0.7}, size = h, radius = 1.2 } }
local meshes = {
  voronoi = mesh.voronoi { size = 5*h, refine = near_hole, seed = 3 },
  quads   = mesh.gmsh { cells = "quads", size = 5*h, refine = near_hole },
}

return Scene {
  title = "A plate with a hole",
  plane = "strain",
  geometry = {
    plate = Polygon { {1,0,"bottom"}, {6,0,"right"}, {6,6,"top"}, {0,6,"left"}, {0,1,"hole", arc = { center = {0,0} }},
                      material = steel },
  },
  mesh = meshes[kind],
  element = "vem",
  supports = { ["plate.bottom"] = "y", ["plate.left"] = "x" },
  stages = {
    Stage { "pull", tractions = { ["plate.right"] = { x = xx, y = xy }, ["plate.top"] = { x = xy, y = yy } } },
  },
  outputs = {
    probes = { side = { "displacement", at = {1,0} }, crown = { "displacement", "stress", at = {0,1} } },
  },
}
