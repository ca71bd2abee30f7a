local grading = { forms = { "number" }, range = { from = 1e-4, to = 1e4 } }

return {
  name = "meshing_structured",
  doc = "Rows and columns of quadrilaterals in four-sided regions.",
  provides = {
    { kind = "mesh", name = "structured", constructor = "mesh.structured",
      doc = "Quadrilaterals in rows and columns; regions must have four sides, straight or curved.",
      parameters = {
        { key = "cells", forms = { "list" }, each = { forms = { "integer" }, range = { from = 1, to = 1e5 } },
          doc = "{ columns, rows } of every region" },
        { key = "size", forms = { "number" }, dimension = "m", range = { above = 0 },
          doc = "wished side of cells, instead of cells" },
        { key = "grading", forms = { "number", "list" }, default = 1, numerical = true,
          range = { from = 1e-4, to = 1e4 }, each = grading,
          doc = "last cell's side over the first one's, along x and y or { along x, along y }" },
        { key = "regions", forms = { "map" }, each = { forms = { "table" } },
          doc = "other cells, size or grading for a region: { dam = { cells = {4, 8} } }" },
      } },
  },
}
