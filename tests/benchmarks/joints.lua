-- A square cut by rough joints side by side, pressed by its weight and from two sides: many contact points.
local cells = param { "cells", default = 20000, doc = "number of cells" }
local count = param { "count", default = 4, doc = "number of joints" }
local rock = material.elastic { E = 10e9, nu = 0.25, unit_weight = 25e3 }
local joints = {}
for i = 1, count do
  local x = 2*i/(count + 1)
  joints["joint" .. i] = Joint { path = { {x - 0.2,0}, {x + 0.2,2} }, pairing = "mortar", enforce = "lagrange",
                                 friction = contact.coulomb { friction_angle = math.atan(0.5) } }
end

return Scene {
  title = "Many contact points", plane = "strain",
  geometry = { body = Rectangle { from = {0,0}, to = {2,2}, material = rock } },
  joints = joints, mesh = mesh.voronoi { cells = cells, seed = 3 },
  supports = { ["body.bottom"] = "xy", ["body.left"] = "x" },
  stages = {
    Stage { "weight", gravity = true, pressures = { ["body.right"] = 1e5 } },
    Stage { "load", pressures = { ["body.right"] = 1e5, ["body.top"] = function(x) return 2e5*x end } },
  },
  outputs = { fields = { "displacement", "stress" } },
}
