-- expect 7: needs at least 3 corners, got 2
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Polygon { {0,0,"bottom"}, {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
