-- expect 11: measure.a.stage: the measure 'a' is missing: the scene has no stage 'wieght'
-- expect: did you mean 'weight'?
-- expect 12: measure.b.probe: the measure 'b' is missing: the scene has no probe 'tip'
-- expect 13: measure.c.quantity: the measure 'c' is missing: the probe 'top' reads no 'uz'
-- expect 14: measure.d.quantity: the measure 'd' is missing: the probe 'side' reads no 'syx'
-- expect 15: measure.e.joint: the measure 'e' is missing: the scene has no joint 'fault'
-- expect 16: measure.f.at: the measure 'f' is missing: the scene has no stage 'wait'
return Study { title = "x", scene = "scenes/block.lua",
  vary = { cells = { 16 } },
  measure = {
    a = { stage = "wieght", probe = "top", quantity = "uy", reference = 1 },
    b = { probe = "tip", quantity = "uy", reference = 1 },
    c = { probe = "top", quantity = "uz", reference = 1 },
    d = { probe = "side", quantity = "syx", reference = 1 },
    e = { joint = "fault", quantity = "max_slip", reference = 1 },
    f = { at = "stages.wait.balance.load.x", reference = 1 } },
}
