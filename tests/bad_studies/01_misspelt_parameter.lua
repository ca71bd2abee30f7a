-- expect 5: vary.cels[1]: the scene has no parameter 'cels'
-- expect: did you mean 'cells'?
return Study {
  title = "x", scene = "scenes/block.lua",
  vary = { cels = { 16, 64 } },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
