-- Linear elasticity of plane solids.
return {
  name = "elasticity",
  doc = "The elastic solid: virtual elements on any polygon, Hooke's law, stresses in cells and at points.",
  provides = {
    { kind = "element", name = "vem", constructor = "element.vem",
      doc = "Virtual element of order 1: any simple polygon, non-convex or with hanging nodes.",
      parameters = {
        { key = "stabilisation", forms = { "object" }, kind = "stabilisation", default = "bending", numerical = true,
          doc = "How deformation that the linear projection does not see is stiffened." },
      } },
    { kind = "stabilisation", name = "bending", constructor = "stabilisation.bending",
      doc = "Scaled by the plane modulus E' and the cell's second moments: rectangles of any aspect bend exactly.",
      parameters = {} },
    { kind = "stabilisation", name = "shear", constructor = "stabilisation.shear",
      doc = "factor times the shear modulus, the same in all directions.",
      parameters = {
        { key = "factor", forms = { "number" }, default = 0.5, numerical = true, range = { above = 0 },
          usual = { from = 0.05, to = 5 }, doc = "Multiple of the shear modulus." },
      } },
    { kind = "stabilisation", name = "diagonal", constructor = "stabilisation.diagonal",
      doc = "Diagonal of the shear part of the consistent stiffness (diagonal recipe).",
      parameters = {} },
    { kind = "material", name = "elastic", constructor = "material.elastic",
      doc = "Isotropic Hooke's law, plane strain or plane stress.",
      parameters = {
        { key = "E", forms = { "number" }, dimension = "Pa", required = true, range = { above = 0 },
          usual = { from = 1e6, to = 1e12 }, doc = "Young's modulus." },
        { key = "nu", forms = { "number" }, required = true, range = { above = -1, to = 0.5 },
          usual = { from = 0, to = 0.4999 },
          doc = "Poisson's ratio; below 0.5 in plane strain." },
        { key = "unit_weight", forms = { "number" }, dimension = "N/m^3", range = { from = 0 },
          usual = { from = 1e3, to = 1e5 }, doc = "Weight per volume; stages with gravity need this or density." },
        { key = "density", forms = { "number" }, dimension = "kg/m^3", range = { from = 0 },
          usual = { from = 100, to = 1e4 }, doc = "Mass per volume; its weight is density times the stage's gravity." },
      } },
  },
  effects = {
    { name = "elasticity", called_by = { "scene.geometry" }, nonlinear = false,
      doc = "Linear elastic equilibrium of all regions, small displacements.",
      left_out = "Elasticity: without it nothing carries load." },
  },
}
