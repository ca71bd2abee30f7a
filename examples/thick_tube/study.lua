-- What does the widening of a tube that yields to the middle of its wall cost? Hill gives it in closed form.
local u = units
local E, nu, Y, rho = 20*u.GPa, 0.3, 20*u.MPa, 1.5*u.m
local a, b = 1*u.m, 2*u.m
local p = Y * (math.log(1.5) + 0.5 * (1 - 1.5^2 / 4))
local cases = {}
local function run(kind, order, shape)
  for _, size in ipairs { 0.2, 0.1, 0.05, 0.025 } do
    cases[#cases + 1] = { plane = "axisymmetric", yields = true, pressure = p,
                          element = kind, order = order, cells = shape, size = size*u.m }
  end
end
run("vem", 1, "voronoi")
run("vem", 2, "voronoi")
run("vem", 3, "voronoi")
run("vem", 1, "quads")
run("vem", 2, "quads")
run("fem", 1, "quads")
run("fem", 2, "quads")

return Study {
  title = "A thick tube that yields: what accuracy costs",
  cases = cases, refine = "size",
  measure = {
    inside = { title = "the widening inside", probe = "inside", quantity = "ux",
               reference = -(1 + nu) * (1 - 2*nu) * a * p / E + (1 - nu^2) * Y * rho^2 / (E * a) },
    outside = { title = "the widening outside", probe = "outside", quantity = "ux",
                reference = (1 - nu^2) * Y * rho^2 / (E * b) },
  },
}
