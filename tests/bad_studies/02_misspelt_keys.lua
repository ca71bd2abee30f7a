-- expect 8: varry: unknown key 'varry'
-- expect: did you mean 'vary'?
-- expect 9: measure.top.prob: unknown key 'prob'
-- expect: did you mean 'probe'?
-- expect 10: repeats: must be at least 1 and at most 100, got 0
return Study {
  title = "x", scene = "scenes/block.lua",
  varry = { cells = { 16, 64 } },
  measure = { top = { prob = "top", quantity = "uy", reference = 1 } },
  repeats = 0,
}
