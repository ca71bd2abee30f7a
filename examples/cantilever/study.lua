-- What does leaning the inner edge cost in accuracy? The exact deflection of the tip is M L^2 / (2 E I).
local u = units
local length, depth, moment, E = 40*u.m, 8*u.m, 16*u.MN*u.m, 1000*u.MPa

return Study {
  title = "Cantilever of two cells: what a distorted mesh costs",
  vary = { distortion = { 0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3 } },
  problem = { "distortion" },
  measure = {
    tip = { title = "the deflection of the tip", probe = "tip", quantity = "uy",
            reference = moment * length^2 / (2 * E * depth^3 * 1*u.m / 12) },
  },
}
