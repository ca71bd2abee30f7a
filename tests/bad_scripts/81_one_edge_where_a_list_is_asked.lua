-- expect 12: stages[1].water.on: must be a list of: a text, got the text "rock.left"
-- expect: put it into braces: { "rock.left" }
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "w", water = Water { level = 4*u.m, on = "rock.left" } } },
}
