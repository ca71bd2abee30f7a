-- How contact is paired and enforced: does the answer depend on it, and what does it cost?
local cases = {}
-- Multipliers come first: of runs with as many unknowns, the first is what the others are compared with.
for _, pairing in ipairs { "one_pass", "two_passes", "node_insertion", "mortar" } do
  for _, enforce in ipairs { "lagrange", "augmented_lagrange" } do
    cases[#cases + 1] = { pairing = pairing, enforce = enforce }
  end
  for exponent = 0, 6 do
    cases[#cases + 1] = { pairing = pairing, enforce = "penalty", factor = 10^exponent }
  end
end

return Study {
  title = "Jointed dam: pairing and enforcement",
  cases = cases, refine = false,
  measure = {
    crest = { title = "the displacement of the crest", stage = "reservoir", probe = "crest", quantity = "u",
              reference = "finest" },
    force = { title = "the joint's normal force", stage = "reservoir", joint = "fault", quantity = "normal_force",
              reference = "finest" },
    penetration = { title = "penetration over the mesh size", stage = "reservoir", joint = "fault",
                    quantity = "penetration_over_h", reference = 0 },
  },
}
