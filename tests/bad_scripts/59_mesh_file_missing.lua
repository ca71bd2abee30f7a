-- expect 9: there is no file 'meshes/nowhere.msh'
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = MeshGroup { material = rock } },
  mesh = mesh.file { path = "meshes/nowhere.msh" },
  element = "vem",
  supports = { bottom = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
