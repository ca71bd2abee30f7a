-- expect 6: cases[2]: the case cells = 16, mesh = voronoi is there already, from line 5
-- expect 7: cases[3].cells: must be a number, a text or a boolean, got a table
return Study { title = "x", scene = "scenes/block.lua",
  cases = {
    { mesh = "voronoi", cells = 16 },
    { cells = 16, mesh = "voronoi" },
    { cells = { 16, 64 } } },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
