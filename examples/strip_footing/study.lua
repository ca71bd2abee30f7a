-- What does the limit load cost? Prandtl gives it in closed form.
local u = units
local cases = {}
for _, order in ipairs { 1, 2 } do
  for _, fine in ipairs { 0.1, 0.05, 0.03, 0.02 } do
    cases[#cases + 1] = { order = order, fine = fine*u.m }
  end
end

return Study {
  title = "Strip footing: what the limit load costs",
  cases = cases, refine = "fine",
  measure = {
    load = { title = "the limit load", at = "stages.push.balance.reactions.footing.y",
             reference = -0.5 * (2 + math.pi) * 10e3 },
  },
}
