return {
  name = "meshing_gmsh",
  doc = "Triangles and recombined quadrilaterals by the Gmsh library.",
  provides = {
    { kind = "mesh", name = "gmsh", constructor = "mesh.gmsh",
      doc = "Triangles, or quadrilaterals with few triangles left, that follow borders and joints.",
      parameters = {
        { key = "size", forms = { "number", "map", "function" }, dimension = "m", refers = "region", required = true,
          range = { above = 0 },
          each = { forms = { "number" }, dimension = "m", range = { above = 0 },
                   doc = "size in the region of this name" },
          doc = "wished length of edges: a length, one per region, or a function of x and y" },
        { key = "cells", forms = { "text" }, choices = { "triangles", "quads" }, default = "triangles",
          doc = "shape of cells" },
        { key = "algorithm", forms = { "text" }, choices = { "frontal", "delaunay", "meshadapt" },
          default = "frontal", numerical = true, doc = "Gmsh's method of triangulation" },
        { key = "refine", forms = { "list" }, each = { forms = { "object" }, kind = "refinement" },
          doc = "finer cells near places, probes and joints: { { at = {x, y}, size = h, radius = r } }; see `ashlar describe refinement`" },
        { key = "grading", forms = { "number" }, default = 0.3, numerical = true, range = { above = 0, to = 1 },
          doc = "greatest growth of the size per length" },
      } },
  },
}
