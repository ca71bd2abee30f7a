-- expect 13: stages[1].pressures.rock.tpo: must be in Pa, got 3 kN
-- expect 13: stages[1].pressures.rock.tpo: there is no edge 'rock.tpo'
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true,
    pressures = { ["rock.tpo"] = 3*u.kN } } },
}
