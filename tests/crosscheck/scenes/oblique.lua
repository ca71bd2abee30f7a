-- A square under a uniform pressure on one side, cut by an elastic interface at 45°.
local u = units
local MPa_mm = u.MPa/u.mm
local mesh_word = param { "mesh", default = "voronoi" }
local rock = material.elastic { E = 30*u.GPa, nu = 0.2 }
return Scene {
  title = "Oblique elastic interface", plane = "stress",
  geometry = { square = Rectangle { from = {0,0}, to = {1,1}, material = rock } },
  joints = { cut = Joint { path = { {0,0}, {1,1} },
    normal_law = contact.linear { stiffness = 20*MPa_mm },
    friction = contact.coulomb { friction_angle = 60*u.deg, stiffness = 40*MPa_mm } } },
  mesh = mesh_word == "voronoi" and mesh.voronoi { size = 0.1, seed = 2 } or mesh.gmsh { size = 0.1 },
  element = "vem", order = 1,
  supports = { ["square.left"] = "x", foot = Support { at = {0,1}, fix = "xy" } },
  stages = { Stage { "press", pressures = { ["square.right"] = 1*u.MPa } } },
  outputs = { probes = { right = { "displacement", at = {1,0} }, right2 = { "displacement", at = {1,0.5} } } },
}
