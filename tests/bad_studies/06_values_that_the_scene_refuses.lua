-- expect 8: vary.cells[2]: 'cells' must be at least 4, got 2
-- expect 9: vary.mesh[1]: 'mesh' cannot be "square"
-- expect 10: vary.height[2]: must be of the kind of its default
-- expect: did you mean 'squares'?
return Study {
  title = "x", scene = "scenes/block.lua",
  vary = {
    cells = { 16, 2 },
    mesh = { "square" },
    height = { 2, 3*units.kN } },
  refine = "cells",
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
