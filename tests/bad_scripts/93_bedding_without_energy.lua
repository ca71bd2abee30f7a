-- expect 5: material.nu12: asks for strains of negative energy
-- expect: between -0.707107 and 0.707107
-- found by check
local u = units
local rock = material.orthotropic { E1 = 5*u.GPa, E2 = 10*u.GPa, G12 = 2*u.GPa, nu12 = 0.9, bedding = 30*u.deg }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "load", pressures = { ["rock.top"] = 1*u.kPa } } },
}
