-- A block on a smooth slope against a wall; or nothing holds it.
local held = param { "held", default = "wall", choices = { "wall", "slope", "nothing" }, doc = "what holds the block" }
local rock = material.elastic { E = 1e9, nu = 0.25, unit_weight = 24e3 }
local supports = { ["block.bottom"] = "xy", ["block.right"] = "x" }
if held == "slope" then supports = { ["block.bottom"] = "xy" } end
local joints = { slope = Joint { path = { {0,2}, {2,1} }, friction = "none", enforce = contact.penalty { factor = 100 } } }
if held == "nothing" then supports, joints = { ["block.bottom"] = "y" }, nil end

return Scene {
  title = "A block on a slope", plane = "strain",
  geometry = { block = Rectangle { from = {0,0}, to = {2,4}, material = rock } },
  joints = joints,
  mesh = mesh.voronoi { cells = 60 }, element = "vem",
  supports = supports,
  stages = { Stage { "weight", gravity = true } },
  outputs = { fields = { "displacement", "stress" } },
}
