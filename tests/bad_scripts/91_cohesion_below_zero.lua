-- expect 4: material.cohesion: must be at least 0 Pa
-- found by check
local u = units
local rock = material.drucker_prager { E = 10*u.GPa, nu = 0.3, cohesion = -1*u.MPa, friction = 30*u.deg, dilation = 0 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "load", pressures = { ["rock.top"] = 1*u.kPa } } },
}
