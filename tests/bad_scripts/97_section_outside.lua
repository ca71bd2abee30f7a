-- expect 16: the section 'above' lies outside the body
-- expect 17: is no single line with two ends
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock with a hole",
  plane = "strain",
  geometry = { rock = difference { Rectangle { from = {0,0}, to = {10,5} },
                                   Disk { center = {5,2.5}, radius = 1, name = "hole" }, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { sections = {
    -- nothing but air up there
    above = Section { {0,6}, {10,6} },
    round = Section { edge = "rock.hole" },
  } },
}
