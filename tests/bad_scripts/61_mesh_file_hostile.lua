-- expect: meshes/hostile.msh:10: the file is too short for a count of 4000000000000
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = MeshGroup { material = rock } },
  mesh = mesh.file { path = "meshes/hostile.msh" },
  element = "vem",
  supports = { bottom = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
