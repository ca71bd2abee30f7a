local mm = 1e-3
local chords = "Lame's closed form; chords of 0.1 m take 0.3 % of it"
local exact = "Lame's closed form: exact at the mesh points of one row of quadrilaterals, so round-off only"
local hill = "Hill's closed form for yielding to r = 1.5 m; discretisation with cells of 0.1 m"
local lame = 1.3*10e6/(20e9*3) * (0.4*1 + 4/1)
local p = 20e6 * (math.log(1.5) + 0.5*(1 - 1.5^2/4))

return {
  { numbers = { { at = "stages.pressure.probes.inside.ux", value = lame, tolerance = 4e-3*lame, why = chords } } },
  { set = { plane = "axisymmetric", cells = "quads", order = 1 },
    numbers = { { at = "stages.pressure.probes.inside.ux", value = lame, tolerance = 1e-10*lame, why = exact } } },
  { set = { plane = "axisymmetric", yields = true, pressure = p },
    numbers = {
      { at = "stages.pressure.probes.inside.ux", value = 1.722908*mm, tolerance = 2e-4*1.723*mm, why = hill },
      { at = "stages.pressure.probes.outside.ux", value = 1.02375*mm, tolerance = 1e-4*1.024*mm, why = hill },
    } },
}
