-- expect: scenes/block.lua:
-- expect: in the case height = -1
return Study { title = "x", scene = "scenes/block.lua",
  vary = { cells = { 16 }, height = { 1, -1 } }, refine = "cells",
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
