-- Reference: cells of 0.75 m. Tolerances are twice the difference that cells of 3 m make.
local mm, MN = 1e-3, 1e6
local mesh_error = "discretisation with cells of 3 m against 0.75 m"
local balance = "nodal forces balance the loads on one side: round-off only"
-- Weight and centroid of the section's two trapezoids; the middle of the base is at x = 35.
local function trapezoid(below, above, height)
  return (below + above)/2*height, (below^2 + below*above + above^2)/(3*(below + above))
end
local lower, lower_x = trapezoid(70, 19.25, 66.5)
local upper, upper_x = trapezoid(19.25, 14.8, 36.5)
local weight = (lower + upper)*2643*9.80665
local lever = 35 - (lower*lower_x + upper*upper_x)/(lower + upper)
local water = 9810*91.75^2/2
local area = (70 + 19.25)/2*66.5 + (19.25 + 14.8)/2*36.5

return {
  {
    numbers = {
      { at = "stages.own weight.balance.load.y", value = -area*2643*9.80665, tolerance = 1e-9*93*MN,
        why = "area of the section times its weight by volume: exact on polygons, so round-off only" },
      { at = "stages.own weight.probes.crest.ux", value = -11.01*mm, tolerance = 0.13*mm, why = mesh_error },
      { at = "stages.own weight.probes.crest.uy", value = -8.567*mm, tolerance = 0.05*mm, why = mesh_error },
      { at = "stages.reservoir.balance.load.x", value = 9810*91.75^2/2, tolerance = 1e-9*41*MN,
        why = "unit weight times depth squared over 2: integrated exactly, so round-off only" },
      { at = "stages.own weight.sections.base.N", value = -weight, tolerance = 1e-9*weight, why = balance },
      { at = "stages.own weight.sections.base.V", value = 0, tolerance = 1e-9*weight, why = balance },
      { at = "stages.own weight.sections.base.M", value = weight*lever, tolerance = 70e-9*weight, why = balance },
      { at = "stages.reservoir.sections.base.N", value = -weight, tolerance = 1e-9*weight, why = balance },
      { at = "stages.reservoir.sections.base.V", value = water, tolerance = 1e-9*weight, why = balance },
      { at = "stages.reservoir.sections.base.M", value = weight*lever - water*91.75/3, tolerance = 70e-9*weight,
        why = balance },
      { at = "stages.reservoir.sections.waist.begin.sn", value = -1.2176*MN, tolerance = 0.012*MN, why = mesh_error },
      { at = "stages.reservoir.sections.waist.end.s3", value = -1.6036*MN, tolerance = 0.006*MN, why = mesh_error },
      { at = "stages.reservoir.sections.waist.begin.s1", value = -9810*61.75, tolerance = 0.004*MN,
        why = "on the upstream face the pressure of the water; cells of 3 m miss it by half of this" },
      { at = "stages.reservoir.probes.crest.ux", value = 6.287*mm, tolerance = 0.045*mm, why = mesh_error },
      { at = "stages.reservoir.probes.crest.uy", value = -4.327*mm, tolerance = 0.02*mm, why = mesh_error },
      { at = "stages.reservoir.probes.neck.ux", value = 5.094*mm, tolerance = 0.02*mm, why = mesh_error },
    },
  },
}
