-- expect 4: material.dilation: must not exceed friction
-- found by check
local u = units
local rock = material.mohr_coulomb { E = 10*u.GPa, nu = 0.3, cohesion = 1*u.MPa, friction = 0, dilation = 5*u.deg }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "load", pressures = { ["rock.top"] = 1*u.kPa } } },
}
