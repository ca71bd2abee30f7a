-- expect 4: without.contact: names no parameter that leaves 'contact' out
return Study { title = "x", scene = "scenes/block.lua",
  vary = { cells = { 16 } },
  without = { contact = {} },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
