return {
  name = "gravity",
  doc = "Self-weight of regions, downwards (against y).",
  extends = {
    stage = {
      { key = "gravity", forms = { "boolean", "number" }, dimension = "m/s^2",
        range = { from = 0 }, usual = { from = 0, to = 30 },
        doc = "self-weight of all regions: true for 9.80665 m/s^2, or the acceleration; false: none. "
           .. "Materials given by their density weigh in with it; those given by their unit weight keep that" },
    },
  },
  effects = {
    { name = "gravity", called_by = { "stage.gravity" }, nonlinear = false,
      doc = "Self-weight: the body force -w in y on every region, with exact weights on any polygon.",
      left_out = "Self-weight: it matters when stresses of about unit weight times height (24 kPa for each metre "
              .. "of rock) count beside those of the other loads, and whenever joints are closed by weight." },
  },
}
