-- A block on a rough joint that slips in part. Lengths times m, stresses times pa: other units.
local m  = param { "m", default = 1, doc = "what the unit of length is multiplied by" }
local pa = param { "pa", default = 1, doc = "what the unit of stress is multiplied by" }
local rock = material.elastic { E = 10e9*pa, nu = 0.25 }

return Scene {
  title = "A block on a joint", plane = "strain",
  geometry = {
    ground = Rectangle { from = {0,0}, to = {4*m,2*m}, material = rock },
    block  = Rectangle { from = {0,2*m}, to = {4*m,4*m}, material = rock },
  },
  joints = { seam = Joint { between = { "block", "ground" }, friction = "none",
                            enforce = contact.penalty { factor = 100 } } },
  mesh = mesh.structured { cells = {8,4} },
  supports = { ["ground.bottom"] = "xy", ["block.left"] = "x" },
  stages = { Stage { "press", pressures = { ["block.top"] = function(x, _) return 1e6*pa*(3*m - x)/m end } } },
  outputs = { fields = { "displacement", "stress" }, probes = { top = { "displacement", at = {4*m,4*m} } } },
}
