return {
  name = "power", doc = "Friction of rough rock as a power of the pressure.",
  provides = {
    { kind = "friction", name = "power", constructor = "contact.power",
      doc = "Shear strength A (p/1 MPa)^b, and part of it worn away by slip.",
      parameters = {
        { key = "A", forms = { "number" }, dimension = "Pa", required = true, range = { above = 0 },
          doc = "Strength at 1 MPa before any slip." },
        { key = "b", forms = { "number" }, required = true, range = { above = 0, to = 1 }, doc = "Exponent." },
        { key = "wear", forms = { "number" }, dimension = "m", required = true, range = { above = 0 },
          doc = "Slip that wears away half of the strength." },
      } },
  },
}
