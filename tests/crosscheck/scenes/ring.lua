-- A thick tube under inner pressure around its axis: a section along the radius has Lamé's stresses.
local u = units
local steel = material.elastic { E = 200*u.GPa, nu = 0.3 }
return Scene {
  title = "Ring",
  plane = "axisymmetric",
  geometry = { ring = Rectangle { from = {1,0}, to = {2,0.5}, material = steel } },
  mesh = mesh.structured { cells = {20,10} },
  element = "vem", order = 2,
  supports = { ["ring.bottom"] = "y", ["ring.top"] = "y" },
  stages = { Stage { "pressure", pressures = { ["ring.left"] = 10*u.MPa } } },
  outputs = { fields = { "displacement" }, sections = { wall = Section { {1,0.23}, {2,0.23} } } },
}
