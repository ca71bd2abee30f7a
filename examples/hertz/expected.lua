-- Peaks of reference.csv, by CalculiX: see README.md.
local flat_top, pole = 83.127, 83.961

local function peak(reference, share, why)
  return { at = "stages.press.joints.touch.max_pressure", value = reference, tolerance = share*reference, why = why }
end
local force = { at = "stages.press.joints.touch.resultant.y", value = 100, tolerance = 1e-8,
                why = "the contact carries the load, to round-off" }
-- Means of the gap act across its width, some centimetres at the edge of the contact: a moment of 1e-9 is left.
local balance = 1e-8

return {
  { balance = balance, numbers = { peak(flat_top, 0.003, "0.09 % off with this mesh"), force,
      { at = "stages.press.joints.touch.penetration_over_h", value = 0, tolerance = 1e-12,
        why = "multipliers leave no penetration" } } },
  { balance = balance, set = { cells = 389 }, numbers = { peak(flat_top, 0.01, "0.02 % off by luck: the peak moves with the mesh"), force } },
  { balance = balance, set = { loading = "pole" }, numbers = { peak(pole, 0.003, "0.09 % off with this mesh"), force } },
  { balance = balance, set = { order = 2, cells = 1155 },
    numbers = { peak(flat_top, 0.002, "0.02 % off with this mesh"), force } },
  { balance = balance, set = { order = 2 }, numbers = { peak(flat_top, 0.002, "0.02 % off with this mesh"), force } },
  { balance = balance, set = { pairing = "node_to_segment", enforce = "penalty" },
    numbers = { peak(flat_top, 0.003, "0.15 % off: the penalty gives way by a thousandth of a cell"), force } },
}
