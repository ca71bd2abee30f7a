-- Does the pressure along the interface tend to one curve, whatever the cells?
return Study {
  title = "Two rectangles: the pressure between them",
  vary = {
    shape = { "triangles", "quads", "voronoi" }, match = { true, false },
    cells = { 50, 100, 200, 300, 500, 1000, 2000, 4000 },
  },
  refine = "cells",
  measure = {
    peak = { title = "the greatest pressure", joint = "interface", quantity = "max_pressure", reference = 61.590e6 },
    force = { title = "the normal force", joint = "interface", quantity = "normal_force", reference = 115.595e6 },
  },
}
