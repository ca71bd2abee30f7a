local u = units
local pairing = param { "pairing", default = "mortar" }
local enforce = param { "enforce", default = "lagrange" }
local tilt = param { "tilt", default = 0.0 }
local order = param { "order", default = 1 }
local element = param { "element", default = "vem" }
local ratio = param { "ratio", default = 3.0 }
local meshes = param { "meshes", default = "quads" }
local rock = material.elastic { E = 1*u.GPa, nu = 0.3 }
local a = math.rad(tilt)
local t = math.tan(a)
return Scene {
  title = "Contact patch test", plane = "strain",
  geometry = {
    lower = Polygon { {0,0,"bottom"}, {2,0,"r"}, {2,1+2*t,"face"}, {0,1,"left"}, material = rock },
    upper = Polygon { {0,1,"face"}, {2,1+2*t,"r"}, {2,3,"top"}, {0,3,"left"}, material = rock } },
  joints = { bed = Joint { faces = { "upper.face", "lower.face" }, pairing = pairing, enforce = enforce,
     friction = tilt == 0 and "none" or contact.coulomb { friction_angle = 70*u.deg } } },
  mesh = meshes == "quads" and mesh.gmsh { cells = "quads", size = { upper = 0.5, lower = 0.5/ratio } } or mesh.voronoi { size = { upper = 0.5, lower = 0.5/ratio }, seed = 5 },
  element = element, order = order,
  supports = { ["lower.bottom"] = "y", foot = Support { at = {0,0}, fix = "xy" } , pin = Support{ at = {0,3}, fix = "x" } },
  stages = { Stage { "press", pressures = { ["upper.top"] = 1*u.MPa } } },
}
