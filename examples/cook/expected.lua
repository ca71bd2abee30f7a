local mm = 1e-3
local stress = "23.967, Richardson of independent fine meshes; its own distance at this size"
local strain = "7.765 at 256 cells a side, an independent code; within half a percent at 32"

-- Round-off in the balance of the loads weighs lambda/mu = 5000 times as much near nu = 0.5.
local rounded = 1e-8

return {
  { numbers = { { at = "stages.shear.probes.middle.uy", value = 23.967*mm, tolerance = 0.1*mm, why = stress } } },
  { set = { order = 2 },
    numbers = { { at = "stages.shear.probes.middle.uy", value = 23.967*mm, tolerance = 0.03*mm, why = stress } } },
  { balance = rounded, set = { order = 2, divide = 32, plane = "strain" },
    numbers = { { at = "stages.shear.probes.corner.uy", value = 7.765*mm, tolerance = 0.005*7.765*mm, why = strain } } },
  { balance = rounded, set = { order = 2, divide = 32, plane = "strain", element = "none" },
    numbers = { { at = "stages.shear.probes.corner.uy", value = 7.765*mm, tolerance = 0.005*7.765*mm, why = strain } } },
  { balance = rounded, set = { order = 2, divide = 32, plane = "strain", cells = "voronoi" },
    numbers = { { at = "stages.shear.probes.corner.uy", value = 7.765*mm, tolerance = 0.005*7.765*mm, why = strain } } },
  { balance = rounded, set = { order = 2, divide = 32, plane = "strain", cells = "triangles" },
    numbers = { { at = "stages.shear.probes.corner.uy", value = 7.765*mm, tolerance = 0.005*7.765*mm, why = strain } } },
}
