-- expect 5: measure.top.reference: must be in m, got 3 kPa
-- expect 6: measure.side.reference: 'finnest' is none of the choices
return Study { title = "x", scene = "scenes/block.lua", vary = { cells = { 16, 64 } },
  measure = {
    top  = { probe = "top", quantity = "uy", reference = 3*units.kPa },
    side = { probe = "side", quantity = "uy", reference = "finnest" } },
}
