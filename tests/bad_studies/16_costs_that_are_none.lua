-- expect 7: only times are told by effect
-- expect 8: times are those of the whole run
-- expect 9: 'money' is none of the choices
return Study {
  title = "x", scene = "scenes/block.lua", vary = { cells = { 16, 64 } },
  measure = {
    a = { cost = "iterations", effect = "contact" },
    b = { cost = "cpu", stage = "weight" },
    c = { cost = "money" },
  },
}
