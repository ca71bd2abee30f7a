-- expect 5: measure.top.reference: the function, called for cells = 64, fails
-- expect 6: measure.side.reference: the function, called for cells = 16, must return a number, but returns a string
return Study { title = "x", scene = "scenes/block.lua", vary = { cells = { 16, 64 } },
  measure = {
    top  = { probe = "top", quantity = "uy", reference = function(case) return case.cells < 20 and 1 or nothing.at_all end },
    side = { probe = "side", quantity = "uy", reference = function(case) return "much" end } },
}
