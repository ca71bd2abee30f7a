local function modulus(key, doc)
  return { key = key, forms = { "number" }, dimension = "Pa", required = true, range = { above = 0 }, doc = doc }
end
return {
  name = "degrading", doc = "Soil whose shear modulus falls with the greatest shear it has seen.",
  provides = {
    { kind = "material", name = "degrading", constructor = "material.degrading",
      doc = "Hyperbolic shear, unloading along the secant. Plane strain.",
      parameters = {
        modulus("K", "Bulk modulus."), modulus("G", "Shear modulus at small strain."),
        { key = "half", forms = { "number" }, required = true, range = { above = 0 },
          doc = "Shear strain that halves the shear modulus." },
      } },
  },
  effects = {
    { name = "degradation", called_by = { "material.degrading" }, nonlinear = true,
      doc = "Softening of soil with shear.",
      left_out = "Softening of soil with shear: it matters at shear strains beyond one in a thousand." },
  },
}
