-- expect: the scene has no parameter 'jionted'
return Study { title = "x", scene = "scenes/block.lua",
  vary = { cells = { 16 } },
  without = { contact = { jionted = false } },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
