local refinement = { forms = { "table" }, doc = "{ at = {x, y} | point = name | joint = name, size = h, radius = r }" }

return {
  name = "meshing_voronoi",
  doc = "Polygonal meshes: centroidal Voronoi cells that conform to borders and joints.",
  provides = {
    { kind = "mesh", name = "voronoi", constructor = "mesh.voronoi",
      doc = "Voronoi cells of even size and round shape; every border and joint is a union of their edges.",
      parameters = {
        { key = "size", forms = { "number", "map", "function" }, dimension = "m", range = { above = 0 },
          each = { forms = { "number" }, dimension = "m", range = { above = 0 },
                   doc = "size in the region of this name" },
          doc = "wished size of cells, √(area): a length, one per region, or a function of x and y" },
        { key = "cells", forms = { "integer" }, range = { from = 1, to = 1e7 },
          doc = "number of cells, instead of size" },
        { key = "seed", forms = { "integer" }, default = 1, numerical = true, range = { from = 0, to = 1e9 },
          doc = "the same seed gives the same mesh, on every machine" },
        { key = "iterations", forms = { "integer" }, default = 12, numerical = true, range = { from = 0, to = 1000 },
          doc = "Lloyd iterations; more make rounder cells" },
        { key = "refine", forms = { "list" }, each = refinement,
          doc = "finer cells near points and joints; radius defaults to size" },
        { key = "grading", forms = { "number" }, default = 0.3, numerical = true, range = { above = 0, to = 1 },
          doc = "greatest growth of the size per length" },
        { key = "collapse", forms = { "number" }, default = 0.08, numerical = true, range = { from = 0, to = 0.3 },
          doc = "edges shorter than this share of their cell's size are collapsed, unless they carry geometry" },
      } },
  },
}
