-- A block pushed 2 m along a base on which it stands by friction: lips are paired anew in every step.
local u = units
local pairing = param { "pairing", default = "mortar" }
local enforce = param { "enforce", default = "lagrange" }
local far = param { "far", default = 2.0, doc = "in metres" }
local steps = param { "steps", default = 40 }
local order = param { "order", default = 1 }
local rock = material.elastic { E = 10*u.GPa, nu = 0.2 }
return Scene {
  title = "A block slides along a base", plane = "strain",
  geometry = {
    base = Polygon { {0,0,"bottom"}, {6,0}, {6,1,"face"}, {0,1}, material = rock },
    block = Polygon { {1,1,"foot"}, {2,1,"front"}, {2,1.5,"top"}, {1,1.5,"back"}, material = rock },
  },
  joints = { bed = Joint { faces = { "block.foot", "base.face" }, sliding = "finite", pairing = pairing,
                           enforce = enforce, slave = "block", friction = contact.coulomb { friction_angle = 30*u.deg } } },
  mesh = mesh.voronoi { size = 0.17, seed = 2 }, element = "vem", order = order,
  supports = { ["base.bottom"] = "xy" },
  stages = {
    Stage { "press", pressures = { ["block.top"] = 1*u.MPa }, supports = { ["base.bottom"] = "xy" } },
    Stage { "push", steps = steps, supports = { ["base.bottom"] = "xy", ["block.top"] = Support { ux = far } } },
  },
}
