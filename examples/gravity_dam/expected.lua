-- Reference: cells of 0.75 m. Tolerances are twice the difference that cells of 3 m make.
local mm, MN = 1e-3, 1e6
local mesh_error = "discretisation with cells of 3 m against 0.75 m"
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
      { at = "stages.reservoir.probes.crest.ux", value = 6.287*mm, tolerance = 0.045*mm, why = mesh_error },
      { at = "stages.reservoir.probes.crest.uy", value = -4.327*mm, tolerance = 0.02*mm, why = mesh_error },
      { at = "stages.reservoir.probes.neck.ux", value = 5.094*mm, tolerance = 0.02*mm, why = mesh_error },
    },
  },
}
