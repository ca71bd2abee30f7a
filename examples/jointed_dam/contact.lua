-- How contact is paired and enforced: does the answer depend on it, and what does it cost?
local cells = param { "cells", default = 20000, doc = "number of cells" }
local cases = {}
-- Multipliers come first: of runs with as many unknowns, the first is what the others are compared with.
for _, pairing in ipairs { "one_pass", "two_passes", "node_insertion", "mortar" } do
  for _, enforce in ipairs { "lagrange", "augmented_lagrange" } do
    cases[#cases + 1] = { cells = cells, pairing = pairing, enforce = enforce }
  end
  for exponent = 0, 6 do
    cases[#cases + 1] = { cells = cells, pairing = pairing, enforce = "penalty", factor = 10^exponent }
  end
end

local function crest(quantity)
  return { title = "crest " .. quantity, stage = "reservoir", probe = "crest", quantity = quantity, reference = "finest" }
end

return Study {
  title = "Jointed dam: pairing and enforcement",
  cases = cases, refine = false,
  measure = {
    contact = { title = "CPU time of contact", cost = "cpu", effect = "contact" },
    crest_x = crest "ux", crest_y = crest "uy",
    force = { title = "the joint's normal force", stage = "reservoir", joint = "fault", quantity = "normal_force",
              reference = "finest" },
    iterations = { title = "iterations of both stages", cost = "iterations" },
    penetration = { title = "penetration over h", stage = "reservoir", joint = "fault",
                    quantity = "penetration_over_h", reference = 0 },
  },
}
