-- Reference: 51200 quadrilaterals of order 2, matching. Oscillations would raise the greatest pressure: one-pass node to
-- segment, not matching, is off by 3.6 %.
local function presses(set, peak, force)
  return { set = set, numbers = {
    { at = "stages.press.joints.interface.max_pressure", value = 61.590e6, tolerance = peak*61.590e6,
      why = "discretisation: twice the difference at this number of cells" },
    { at = "stages.press.joints.interface.normal_force", value = 115.595e6, tolerance = force*115.595e6,
      why = "discretisation: twice the difference at this number of cells" },
    { at = "stages.press.joints.interface.penetration_over_h", value = 0, tolerance = 1e-14, why = "round-off" } } }
end

return {
  presses({}, 0.0007, 0.002),
  presses({ shape = "quads" }, 0.003, 0.003),
  presses({ shape = "triangles" }, 0.006, 0.008),
  presses({ match = false }, 0.0014, 0.003),
  presses({ match = false, shape = "quads" }, 0.003, 0.003),
  presses({ match = false, shape = "triangles" }, 0.006, 0.008),
  presses({ match = false, pairing = "node_insertion" }, 0.0018, 0.003),
  presses({ match = false, pairing = "node_insertion", shape = "quads" }, 0.0034, 0.003),
  presses({ shape = "quads", order = 2 }, 0.0005, 0.0008),
}
