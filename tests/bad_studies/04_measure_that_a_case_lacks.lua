-- expect 8: measure.side.probe: the measure 'side' is missing: the scene has no probe 'side', in the case mark = false
-- expect 9: measure.half.stage: the measure 'half' is missing: the scene has no stage 'half'
-- expect: 2 mistakes
return Study {
  title = "x", scene = "scenes/block.lua",
  vary = { cells = { 16 }, mark = { true, false } },
  measure = {
    side = { probe = "side", quantity = "uy", reference = 1 },
    half = { stage = "half", probe = "top", quantity = "uy", reference = 1 } },
}
