-- Which element gives the deflection of Cook's panel for least?
local cases = {}
local function run(kind, order, finest)
  for _, divide in ipairs { 4, 8, 16, 32, 64, 128 } do
    if divide <= finest then cases[#cases + 1] = { element = kind, order = order, divide = divide } end
  end
end
run("vem", 1, 128)
run("vem", 2, 64)
run("vem", 3, 32)
run("fem", 1, 128)
run("incompatible", 1, 128)
run("fem", 2, 64)

return Study {
  title = "Cook's panel: what accuracy costs",
  cases = cases, refine = "divide",
  measure = {
    middle = { title = "the deflection of the end's middle", probe = "middle", quantity = "uy" },
  },
}
