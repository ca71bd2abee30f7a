local own = "this element's own value; no outside reference. Guards against changes, so round-off only"
local quadratic = "M L^2/(2 E I): order 2 holds the quadratic displacement of bending on any cells"
local known = "bilinear and eight-node quadrilaterals with full integration; published ratios of four digits"

return {
  {
    set = { distortion = 0 },
    numbers = {
      { at = "stages.moment.probes.tip.uy", value = 0.3, tolerance = 1e-12,
        why = "M L^2/(2 E I): rectangles bend exactly with the default stabilisation, so round-off only" },
    },
  },
  { set = { distortion = 1 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.187345794393, tolerance = 1e-9, why = own } } },
  { set = { distortion = 2 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.167461883407, tolerance = 1e-9, why = own } } },
  { set = { element = "vem", order = 2, distortion = 1 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*1, tolerance = 1e-10, why = quadratic } } },
  { set = { element = "vem", order = 2, distortion = 2 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*1, tolerance = 1e-10, why = quadratic } } },
  { set = { element = "fem", order = 1, distortion = 0 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*0.2424, tolerance = 3e-4, why = known } } },
  { set = { element = "fem", order = 1, distortion = 1 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*0.1274, tolerance = 3e-4, why = known } } },
  { set = { element = "fem", order = 1, distortion = 2 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*0.0846, tolerance = 3e-4, why = known } } },
  { set = { element = "fem", order = 2, distortion = 0 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*1, tolerance = 1e-4, why = known } } },
  { set = { element = "fem", order = 2, distortion = 1 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*0.9935, tolerance = 1e-4, why = known } } },
  { set = { element = "fem", order = 2, distortion = 2 },
    numbers = { { at = "stages.moment.probes.tip.uy", value = 0.3*0.8948, tolerance = 1e-4, why = known } } },
}
