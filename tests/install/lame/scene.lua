local plane = param { "plane", default = "strain", doc = "strain or stress" }
local solid = material.lame { lambda = 1e9, mu = 1e9 }

return Scene {
  title = "A block of a stranger's material",
  plane = plane,
  geometry = { block = Polygon { {0,0,"bottom"}, {2,0}, {2,1}, {0,1}, material = solid } },
  mesh = mesh.structured { size = 0.5 },
  supports = { ["block.bottom"] = "xy" },
  stages = { Stage { "at rest" } },
}
