-- A rough strip footing pressed into soil: stresses turn and yield in part of the body.
local u = units
local order = param { "order", default = 1, doc = "order of the element" }
local soil = material.mohr_coulomb {
  E = 10*u.MPa, nu = 0.3, cohesion = 10*u.kPa, friction = 20*u.deg, dilation = 5*u.deg,
}
return Scene {
  title = "A strip footing", plane = "strain",
  geometry = {
    soil = Polygon { {0,0,"bottom"}, {5,0,"right"}, {5,3,"ground"}, {0.5,3,"footing"}, {0,3,"left"}, material = soil },
  },
  mesh = mesh.voronoi { size = 0.35, seed = 2 },
  order = order,
  supports = {
    ["soil.bottom"] = "xy", ["soil.right"] = "x", ["soil.left"] = "x", ["soil.footing"] = { ux = 0, uy = -0.02*u.m },
  },
  stages = { Stage { "push" } },
  outputs = { fields = { "displacement", "stress" } },
}
