-- Two blocks with a neck between them: one is held, the other pulled.
local order = param { "order", default = 1, doc = "order of the element" }
local path  = param { "path", default = "blocks.vtk", doc = "their mesh: [0,1]² and [1.1,2.1]×[0,1]" }
local rock  = material.elastic { E = 10e9, nu = 0 }

return Scene {
  title = "Two blocks and a neck", plane = "strain",
  geometry = { blocks = MeshGroup { "mesh", material = rock } },
  mesh = mesh.file { path = path }, order = order,
  supports = { side = Support { box = { {0,0}, {0,1} }, fix = "xy" } },
  stages = { Stage { "pull", forces = { Force { at = {2.1,0}, x = 500 }, Force { at = {2.1,1}, x = 500 } } } },
  outputs = { fields = { "displacement", "stress" }, probes = { far = { "displacement", at = {2.1,0} } } },
}
