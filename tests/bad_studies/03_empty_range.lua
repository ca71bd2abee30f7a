-- expect 6: vary.cells: is empty: there is nothing to run
-- expect 7: vary.mesh[2]: squares is said twice
return Study {
  title = "x", scene = "scenes/block.lua",
  vary = {
    cells = {},
    mesh = { "squares", "squares" } },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
