-- A column of one width under its own weight between smooth walls: its top settles by γ H² / (2 M).
local u = units
local stuff = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }

return Scene {
  title = "Column between smooth walls",
  plane = "strain",
  geometry = {
    column = Polygon { {0,0,"bottom"}, {3,0,"right"}, {3,12,"top"}, {0,12,"left"}, material = stuff },
  },
  mesh = mesh.structured { cells = {3, 10}, grading = 2 },
  element = "vem",
  supports = { ["column.bottom"] = "y", ["column.left"] = "x", ["column.right"] = "x" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { probes = { top = { "displacement", at = {3,12} } } },
}
