-- Plane solids: elements, stresses, and the laws of their materials.
local weights = {
  { key = "unit_weight", forms = { "number" }, dimension = "N/m^3", range = { from = 0 },
    usual = { from = 1e3, to = 1e5 }, doc = "Weight per volume; stages with gravity need this or density." },
  { key = "density", forms = { "number" }, dimension = "kg/m^3", range = { from = 0 },
    usual = { from = 100, to = 1e4 }, doc = "Mass per volume; its weight is density times the stage's gravity." },
}
local one_weight = { { "unit_weight", "density", least = 0 } }

local function modulus(key, doc, required)
  return { key = key, forms = { "number" }, dimension = "Pa", required = required, range = { above = 0 },
           usual = { from = 1e6, to = 1e12 }, doc = doc }
end
local function ratio(key, doc, required)
  return { key = key, forms = { "number" }, required = required, doc = doc }
end
local nu = { key = "nu", forms = { "number" }, required = true, range = { above = -1, to = 0.5 },
             usual = { from = 0, to = 0.4999 }, doc = "Poisson's ratio; below 0.5 in plane strain." }
local function with_weights(parameters)
  for _, each in ipairs(weights) do parameters[#parameters + 1] = each end
  return parameters
end
-- Laws that yield: elastic moduli, cohesion, friction, dilation, then what is the law's own.
local function frictional(own)
  return with_weights {
    modulus("E", "Young's modulus.", true), nu,
    { key = "cohesion", forms = { "number" }, dimension = "Pa", required = true, range = { from = 0 },
      usual = { from = 1, to = 1e9 }, doc = "Shear strength without normal stress." },
    { key = "friction", forms = { "number" }, required = true, range = { from = 0 },
      doc = "Angle of friction, 0 to below 90 degrees: 30*units.deg." },
    { key = "dilation", forms = { "number" }, required = true, range = { from = 0 },
      doc = "Angle of dilation, 0 to friction: 0 shears at constant volume; friction is the associated flow of " ..
            "limit analysis and the only choice with a symmetric tangent." },
    own,
  }
end

return {
  name = "elasticity",
  doc = "The elastic solid: virtual elements on any polygon, Hooke's law, stresses in cells and at points.",
  provides = {
    { kind = "element", name = "vem", constructor = "element.vem", usual = true,
      doc = "Virtual element of order 1 to 3: any simple polygon, non-convex or with hanging nodes.",
      parameters = {
        { key = "stabilisation", forms = { "object" }, kind = "stabilisation", numerical = true,
          doc = "How deformation that the projected strains do not see is stiffened. Left out: bending, or none " ..
                "where a law yields." },
      } },
    { kind = "element", name = "fem", constructor = "element.fem",
      doc = "Finite elements for comparison: triangles of 3 or 6 nodes, quadrilaterals of 4 or 8; order 1 or 2.",
      parameters = {
        { key = "incompatible", forms = { "boolean" }, default = false,
          doc = "Bending modes inside quadrilaterals of order 1." },
      } },
    { kind = "stabilisation", name = "bending", constructor = "stabilisation.bending",
      doc = "As stiff as the cell against bending: parallelograms of any aspect bend exactly.",
      parameters = {} },
    { kind = "stabilisation", name = "none", constructor = "stabilisation.none",
      doc = "Strains of a higher degree see every deformation; the law is asked at more points. For laws that yield.",
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
    { kind = "exact", name = "exact", constructor = "Exact",
      doc = "A solution known from elsewhere, to measure errors by integrals over the body.",
      parameters = {
        { key = "stage", forms = { "text" }, refers = "stage", doc = "the stage that it belongs to; left out: all" },
        { key = "displacement", forms = { "function" }, doc = "function(x, y) that returns ux, uy [m]" },
        { key = "stress", forms = { "function" },
          doc = "function(x, y) that returns xx, yy, xy and, if it is to count, zz [Pa]; also gives the energy norm" },
      },
      alternatives = { { "displacement", "stress", most = 2 } } },
    { kind = "field", name = "strain", doc = "Strains of cells: xx, yy and the shear angle gamma_xy." },
    { kind = "field", name = "stress", doc = "Stresses of cells: xx, yy, xy, zz [Pa], tension positive." },
    { kind = "field", name = "principal_stress", doc = "Principal stresses of cells in the plane, s1 >= s3 [Pa]." },
    { kind = "field", name = "principal_angle", doc = "Angle of cells from x to the direction of s1 [degrees]." },
    { kind = "field", name = "von_mises", doc = "Von Mises' equivalent stress of cells [Pa]." },
    { kind = "field", name = "utilisation",
      doc = "Used share of the strength of cells' materials, 1 at the limit and at most 10: shear at the same mean " ..
            "stress, or tension. Materials without a strength: 0." },
    { kind = "field", name = "utilisation_nodes", doc = "Utilisation at the mesh points, of the worst side." },
    { kind = "field", name = "stress_nodes", doc = "Stresses recovered at the mesh points [Pa]." },
    { kind = "field", name = "principal_stress_nodes", doc = "Principal stresses at the mesh points [Pa]." },
    { kind = "field", name = "principal_angle_nodes", doc = "Angle at the mesh points from x to s1 [degrees]." },
    { kind = "field", name = "von_mises_nodes", doc = "Von Mises' equivalent stress at the mesh points [Pa]." },
    { kind = "material", name = "elastic", constructor = "material.elastic",
      doc = "Isotropic Hooke's law, plane strain or plane stress.",
      parameters = with_weights {
        modulus("E", "Young's modulus.", true), nu,
        { key = "cohesion", forms = { "number" }, dimension = "Pa", range = { from = 0 },
          usual = { from = 1, to = 1e9 },
          doc = "Shear strength without normal stress. Not simulated, only compared: the field utilisation." },
        { key = "friction", forms = { "number" }, range = { from = 0 },
          doc = "Angle of friction, 0 to below 90 degrees: 30*units.deg. Not simulated, only compared." },
        { key = "tensile_strength", forms = { "number" }, dimension = "Pa", range = { from = 0 },
          doc = "Greatest principal stress, at most cohesion/tan(friction), and just that if left out. Not " ..
                "simulated, only compared." },
      },
      alternatives = one_weight },
    { kind = "material", name = "orthotropic", constructor = "material.orthotropic",
      doc = "Hooke's law of bedded rock: axis 1 in the bedding, 2 across it, 3 out of the plane.",
      parameters = with_weights {
        modulus("E1", "Young's modulus along the bedding.", true),
        modulus("E2", "Young's modulus across the bedding.", true),
        modulus("G12", "Shear modulus along the bedding.", true),
        ratio("nu12", "Shortening in 2 per lengthening in 1, under stress in 1: nu12/E1 = nu21/E2.", true),
        modulus("E3", "Young's modulus out of the plane. Left out: E1, as in the bedding."),
        ratio("nu13", "Shortening in 3 per lengthening in 1, under stress in 1. Left out: nu12."),
        ratio("nu23", "Shortening in 3 per lengthening in 2, under stress in 2. Left out: nu12 E2/E3, as all " ..
              "directions in the bedding are alike."),
        { key = "bedding", forms = { "number" }, required = true,
          doc = "Angle from x to the bedding, counter-clockwise, -180 to 180 degrees: 30*units.deg." },
      },
      alternatives = one_weight },
    { kind = "material", name = "mohr_coulomb", constructor = "material.mohr_coulomb",
      doc = "Elastic up to Mohr-Coulomb's strength and a tension cut-off, then perfectly plastic. Plane strain.",
      parameters = frictional {
        key = "tensile_strength", forms = { "number" }, dimension = "Pa", range = { from = 0 },
        doc = "Greatest principal stress, at most cohesion/tan(friction). Left out: just that, or no limit if " ..
              "friction is 0." },
      alternatives = one_weight },
    { kind = "material", name = "drucker_prager", constructor = "material.drucker_prager",
      doc = "Elastic up to Drucker-Prager's cone, then perfectly plastic. Plane strain.",
      parameters = frictional {
        key = "match", forms = { "text" }, choices = { "outer", "inner", "plane_strain" }, default = "plane_strain",
        doc = "Where the cone meets Mohr-Coulomb: in triaxial compression (outer), triaxial extension (inner), " ..
              "or the limit loads of plane strain." },
      alternatives = one_weight },
    { kind = "material", name = "lua", constructor = "material.lua",
      doc = "A law written in the scenario, for trying ideas; slow: nine calls of the script a point and iteration.",
      parameters = with_weights {
        { key = "stress", forms = { "function" }, required = true,
          doc = "function(strain, state, p) that returns stress { xx, yy, xy, zz } by name, and the new state as a " ..
                "list. Tension positive; strain.xy is the shear angle." },
        { key = "variables", forms = { "integer" }, default = 0, range = { from = 0, to = 64 },
          doc = "Numbers in the state, all 0 at first." },
        { key = "parameters", forms = { "table" },
          doc = "Named numbers that the function gets as p." },
        { key = "symmetric", forms = { "boolean" }, default = true,
          doc = "Promise that the tangent is symmetric, as for laws with an energy." },
      },
      alternatives = one_weight },
  },
  extends = {
    outputs = {
      { key = "exact", forms = { "map" }, each = { forms = { "object" }, kind = "exact" },
        doc = "known solutions by name; errors against them go to the summary and the results for machines" },
    },
  },
  effects = {
    { name = "elasticity", called_by = { "scene.geometry" }, nonlinear = false,
      doc = "Equilibrium of all regions by the laws of their materials, small displacements.",
      left_out = "Elasticity: without it nothing carries load." },
    -- No scene calls for this yet: the plan lists it as left out.
    { name = "inertia", called_by = {}, nonlinear = false,
      doc = "Forces of acceleration.",
      left_out = "Inertia: it matters when loads change within a few natural periods, as in earthquakes." },
    { name = "plasticity", called_by = { "material.mohr_coulomb", "material.drucker_prager" }, nonlinear = true,
      doc = "Yielding of the solid, as the laws of its regions say.",
      left_out = "Yielding and cracking of the solid: they matter where stresses near the strength, as at re-entrant corners and joint tips; stresses there grow without bound as the mesh is refined." },
    -- No scene calls for this yet: the plan lists it as left out.
    { name = "large_displacement", called_by = {}, nonlinear = true,
      doc = "Equilibrium on the deformed shape.",
      left_out = "Large displacement: it matters when rotations exceed about 1 %, or slender parts may buckle." },
  },
}
