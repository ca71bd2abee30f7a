local function cells(doc)
  local limits = { from = 1, to = 1e5 }
  return { key = "cells", forms = { "point" }, range = limits, each = { forms = { "integer" }, range = limits }, doc = doc }
end
local function size(doc)
  return { key = "size", forms = { "number" }, dimension = "m", range = { above = 0 }, doc = doc }
end
local function grading(default, doc)
  local limits = { from = 1e-4, to = 1e4 }
  return { key = "grading", forms = { "number", "point" }, default = default, numerical = true, range = limits,
           each = { forms = { "number" }, range = limits }, doc = doc }
end

return {
  name = "meshing_structured",
  doc = "Rows and columns of quadrilaterals in four-sided regions.",
  provides = {
    { kind = "mesh", name = "structured", constructor = "mesh.structured",
      doc = "Quadrilaterals in rows and columns; regions must have four sides, straight or curved.",
      parameters = {
        cells("{ columns, rows } of every region"),
        size("wished side of cells, instead of cells"),
        grading(1, "last cell's side over the first one's, along x and y or { along x, along y }"),
        { key = "regions", forms = { "map" }, refers = "region",
          each = { forms = { "object" }, kind = "structured_region" },
          doc = "other cells, size or grading for a region: { dam = { cells = {4, 8} } }; "
             .. "see `ashlar describe structured_region`" },
      },
      alternatives = { { "cells", "size", least = 0 }, { "cells", "size", "regions", most = 3 } } },
    { kind = "structured_region", name = "structured_region",
      doc = "What one region's rows and columns have of their own in mesh.structured.",
      parameters = {
        cells("{ columns, rows }"),
        size("wished side of cells, instead of cells"),
        grading(nil, "as the mesh's own grading"),
      },
      alternatives = { { "cells", "size", least = 0 } } },
  },
}
