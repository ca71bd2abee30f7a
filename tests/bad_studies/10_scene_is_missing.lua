-- expect 4: scene: there is no file 'scenes/blok.lua' in the study's folder
-- expect 5: vary.cells: must be 
return Study { title = "x",
  scene = "scenes/blok.lua",
  vary = { cells = 16 },
  measure = { top = { probe = "top", quantity = "uy", reference = 1 } },
}
