-- expect 9: thickness: a body of revolution has no thickness
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3 }
return Scene {
  title = "A shaft",
  plane = "axisymmetric",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  thickness = 2,
  mesh = mesh.structured { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "y" },
  stages = { Stage { "load", pressures = { ["rock.top"] = 1*u.kPa } } },
}
