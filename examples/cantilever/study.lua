-- What does leaning the inner edge cost in accuracy? The exact deflection of the tip is M L^2 / (2 E I).
local u = units
local length, depth, moment, E = 40*u.m, 8*u.m, 16*u.MN*u.m, 1000*u.MPa
local cases = {}
for _, kind in ipairs { { "vem", 1 }, { "vem", 2 }, { "fem", 1 }, { "incompatible", 1 }, { "fem", 2 } } do
  for lean = 0, 4.9, 0.35 do
    cases[#cases + 1] = { element = kind[1], order = kind[2], distortion = lean }
  end
end

return Study {
  title = "Cantilever of two cells: what a distorted mesh costs",
  cases = cases, problem = { "distortion" },
  measure = {
    tip = { title = "the deflection of the tip", probe = "tip", quantity = "uy",
            reference = moment * length^2 / (2 * E * depth^3 * 1*u.m / 12) },
  },
}
