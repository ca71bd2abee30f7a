-- What does leaning the inner edge cost in accuracy? The exact deflection of the tip is M L^2 / (2 E I).
local u = units
local length, depth, moment, E = 40*u.m, 8*u.m, 16*u.MN*u.m, 1000*u.MPa
local cases = {}
local function run(element, order, stabilisation)
  for i = 0, 7 do
    cases[#cases + 1] = { element = element, order = order, stabilisation = stabilisation, distortion = 7*i/10 }
  end
end
for _, stabilisation in ipairs { "bending", "shear", "diagonal", "none" } do run("vem", 1, stabilisation) end
run("vem", 2)
run("fem", 1)
run("fem", 2)
run("incompatible", 1)

return Study {
  title = "Cantilever of two cells: what a distorted mesh costs",
  cases = cases, problem = { "distortion" }, refine = false,
  measure = {
    tip = { title = "the deflection of the tip", probe = "tip", quantity = "uy",
            reference = moment * length^2 / (2 * E * depth^3 * 1*u.m / 12) },
  },
}
