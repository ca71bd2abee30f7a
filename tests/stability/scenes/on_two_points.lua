-- A heavy block that stands on two points: the nearer they are, the less they hold it.
local order = param { "order", default = 1, doc = "order of the element" }
local path  = param { "path", default = "block.vtk", doc = "its mesh: one group, points at (0, 0) and (apart, 0)" }
local apart = param { "apart", default = 0.1, doc = "distance of the points" }
local rock  = material.elastic { E = 10e9, nu = 0.25, unit_weight = 24e3 }

return Scene {
  title = "A block on two points", plane = "strain",
  geometry = { block = MeshGroup { "mesh", material = rock } },
  mesh = mesh.file { path = path }, order = order,
  supports = { foot = Support { at = {0,0}, fix = "xy" }, other = Support { at = {apart,0}, fix = "y" } },
  stages = { Stage { "weight", gravity = true } },
  outputs = { fields = { "displacement", "stress" } },
}
