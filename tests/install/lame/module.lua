return {
  name = "lame", doc = "Linear elasticity by Lamé's constants.",
  provides = {
    { kind = "material", name = "lame", constructor = "material.lame", doc = "An isotropic solid, given by λ and μ.",
      parameters = {
        { key = "lambda", forms = {"number"}, dimension = "Pa", required = true, doc = "First constant λ." },
        { key = "mu", forms = {"number"}, dimension = "Pa", required = true, range = { above = 0 },
          doc = "Shear modulus μ." },
      } },
  },
}
