-- Blocks on each other, held by contact alone, each shifted against the one below.
local u = units
local count = param { "count", default = 4, doc = "blocks on the base" }
local shift = param { "shift", default = 0.1, doc = "of each block against the one below, in its width" }
local rock = material.elastic { E = 10*u.GPa, nu = 0.2, unit_weight = 25*u.kN/u.m^3 }
local geometry = { base = Polygon { {-1,-1,"bottom"}, {count*shift + 2,-1}, {count*shift + 2,0}, {-1,0}, material = rock } }
local joints = {}
for i = 1, count do
  local x, y = (i - 1)*shift, (i - 1)*0.5
  geometry["block" .. i] = Rectangle { from = {x, y}, to = {x + 1, y + 0.5}, material = rock }
  joints["bed" .. i] = Joint { between = { "block" .. i, i == 1 and "base" or "block" .. (i - 1) },
    friction = contact.coulomb { friction_angle = 35*u.deg }, enforce = "lagrange" }
end
return Scene {
  title = "Stacked blocks", plane = "strain", geometry = geometry, joints = joints,
  mesh = mesh.voronoi { size = 0.12, seed = 4 }, element = "vem", order = 1,
  supports = { ["base.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
}
