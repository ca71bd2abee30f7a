-- expect 9: measure.top: its reference is the limit of refined runs, but more than one number is varied
-- expect: refine = "cells"
-- expect 6: problem[1]: the study varies no 'level'
-- expect: valid: cells, height
return Study { title = "x", scene = "scenes/block.lua", problem = {
    "level" },
  vary = { cells = { 16, 64 }, height = { 1, 2 } },
  measure = {
    top = { probe = "top", quantity = "uy" } },
}
