-- expect 8: the mesh file has no cells in a group 'rok'
-- expect: did you mean 'rock'?
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = MeshGroup { "rok", material = rock } },
  mesh = mesh.file { path = "meshes/square.msh" },
  element = "vem",
  supports = { bottom = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
