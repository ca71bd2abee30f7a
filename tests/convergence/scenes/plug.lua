-- A quarter of a block with a round plug of the same rock in it, joined by nothing but contact, under the same
-- pressure from all sides: the plug must feel that pressure all round.
local u = units
local h    = param { "h", default = 0.2*u.m, doc = "size of cells" }
local rock = material.elastic { E = 10*u.GPa, nu = 0.3 }

return Scene {
  title = "A round plug",
  plane = "strain",
  geometry = {
    plug  = Polygon { {0,0,"bottom"}, {1,0,"rim", arc = { center = {0,0} }}, {0,1,"left"}, material = rock },
    block = Polygon { {1,0,"bottom"}, {3,0,"right"}, {3,3,"top"}, {0,3,"left"}, {0,1,"hole", arc = { center = {0,0} }},
                      material = rock },
  },
  joints = { rim = Joint { between = { "block", "plug" }, friction = "none", enforce = contact.penalty { factor = 1000 } } },
  mesh = mesh.voronoi { size = h, seed = 3 },
  element = "vem",
  supports = { ["block.bottom"] = "y", ["plug.bottom"] = "y", ["block.left"] = "x", ["plug.left"] = "x" },
  stages = { Stage { "press", pressures = { ["block.right"] = 1*u.MPa, ["block.top"] = 1*u.MPa } } },
}
