-- The jointed dam with friction and water in the joint, and a reservoir that rises in steps to the crest.
local u = units
local cells  = param { "cells", default = 2000, doc = "number of cells" }
local levels = param { "levels", default = 5, doc = "steps in which the reservoir rises" }

local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
local stages = { Stage { "self-weight", gravity = true } }
for step = 1, levels do
  local level = (10 + 5*step/levels)*u.m
  stages[#stages + 1] = Stage { ("level %d"):format(step), water = Water {
    level = level, on = { "dam.upstream", "rock.bed" }, joints = { "fault" }, unit_weight = 9.81*u.kN/u.m^3 } }
end

return Scene {
  title = "Dam on a jointed foundation, the reservoir rising",
  plane = "strain",
  geometry = {
    rock = Polygon { {0,0,"bottom"}, {25,0,"right"}, {25,10}, {15,10,"base"}, {10,10,"bed"}, {0,10,"left"}, material = rock },
    dam  = Polygon { {10,10,"base"}, {15,10,"downstream"}, {12,15,"crest"}, {10,15,"upstream"}, material = rock },
  },
  joints = { fault = Joint { path = { {4,10}, {10,4} }, friction = contact.coulomb { friction_angle = 15*u.deg },
                             enforce = contact.lagrange {} } },
  mesh = mesh.voronoi { cells = cells, seed = 7 },
  supports = { ["rock.bottom"] = "xy", ["rock.left"] = "xy", ["rock.right"] = "xy" },
  stages = stages,
  outputs = { fields = { "displacement", "stress" }, probes = { crest = { "displacement", at = {10,15} } } },
}
