-- expect 9: center and through are both said
-- expect: say exactly one of center and through
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Polygon { {0,0,"bottom"}, {10,0, arc = Arc { center = {10,2.5}, through = {12.5,2.5} }}, {10,5}, {0,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
