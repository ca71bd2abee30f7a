-- A block pressed on another across a level joint, evenly or so that it opens at one end, between both, or at both.
local kind = param { "enforce", default = "penalty", choices = { "penalty", "lagrange", "augmented" } }
local factor = param { "factor", default = 100.0, doc = "of the penalty" }
local stiffness = param { "stiffness", default = 0.0, doc = "of the penalty [Pa/m]; 0: by its factor" }
local pairing = param { "pairing", default = "node_to_segment" }
local order = param { "order", default = 1 }
local load = param { "load", default = "even", choices = { "even", "one end", "both ends", "middle" }, doc = "where it presses" }
local softer = param { "softer", default = 1.0, doc = "the block's modulus over the ground's" }
local apart = param { "apart", default = false, doc = "the bodies are meshed apart" }
local gap = param { "gap", default = 0.0, doc = "between them" }
local fine = param { "fine", default = 8, doc = "cells of the block along the joint" }
local coarse = param { "coarse", default = 8, doc = "cells of the ground along it" }
local u = units
local E, q = 10*u.GPa, 1*u.MPa
local enforces = { lagrange = contact.lagrange {}, augmented = contact.augmented_lagrange {},
  penalty = stiffness > 0 and contact.penalty { stiffness = stiffness } or contact.penalty { factor = factor } }
local lower, upper = material.elastic { E = E, nu = 0.3 }, material.elastic { E = softer*E, nu = 0.3 }

local pressures = {
  even = q,
  ["one end"] = function(x) return q*(1 - x/2)^3 end,
  ["both ends"] = function(x) return q*(10*(x - 1)^2 - 3) end,
  middle = function(x) return q*(3 - 8*(x - 1)^2) end,
}

return Scene {
  title = "A pressed joint", plane = "strain",
  geometry = {
    ground = Rectangle { from = {0,0}, to = {2,1}, material = lower },
    block = Rectangle { from = {0,1 + gap}, to = {2,2 + gap}, material = upper },
  },
  joints = { seam = Joint { between = not apart and { "block", "ground" } or nil,
    faces = apart and { "block.bottom", "ground.top" } or nil,
    friction = "none", enforce = enforces[kind], pairing = pairing } },
  mesh = mesh.structured { cells = {coarse,4}, regions = { block = { cells = {fine,4} } } },
  element = "vem", order = order,
  supports = { ["ground.bottom"] = "y", foot = Support { at = {0,0}, fix = "xy" },
               head = Support { at = {0,2 + gap}, fix = "x" } },
  stages = { Stage { "press", pressures = { ["block.top"] = pressures[load] } } },
  outputs = { fields = { "displacement", "stress" } },
}
