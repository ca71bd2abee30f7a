-- expect 5: material.friction: must be from 0° to below 90°, got 1718.87°
-- expect: for 30° write 30*units.deg
-- found by check
local u = units
local rock = material.mohr_coulomb { E = 10*u.GPa, nu = 0.3, cohesion = 1*u.MPa, friction = 30, dilation = 0 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "load", pressures = { ["rock.top"] = 1*u.kPa } } },
}
