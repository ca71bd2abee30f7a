-- expect 11: the mesh has no edges named 'botom'
-- expect: valid: bottom
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = MeshGroup { material = rock } },
  mesh = mesh.file { path = "meshes/square.msh" },
  element = "vem",
  supports = { botom = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
