-- What does accuracy cost at the jointed dam, and which cells give it for least?
return Study {
  title = "Jointed dam: what accuracy costs",
  vary = {
    mesh  = { "triangles", "quads", "voronoi" },
    cells = { 500, 1000, 2000, 4000, 8000, 16000 },
  },
  measure = {
    crest = { title = "the settlement of the crest", stage = "reservoir", probe = "crest", quantity = "uy" },
    mouth = { title = "the jump at the joint's mouth", stage = "reservoir",
              probe = "mouth_upper", minus = "mouth_lower", quantity = "u" },
  },
  without = { contact = { jointed = false }, water = { filled = false } },
  repeats = 2,
}
