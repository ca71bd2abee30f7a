local own = "this element's own value; no outside reference. Guards against changes, so round-off only"

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
}
