return {
  name = "water",
  doc = "Still water against faces: hydrostatic pressure below a level.",
  provides = {
    { kind = "water", name = "hydrostatic", constructor = "Water",
      doc = "Still water up to a level against named edges.",
      parameters = {
        { key = "level", forms = { "number" }, dimension = "m", required = true,
          doc = "height y of the free surface" },
        { key = "on", forms = { "list" }, each = { forms = { "text" }, refers = "edge" },
          doc = "names of the wet edges, borders or lips: { \"dam.upstream\", \"rock.bed\" }" },
        { key = "joints", forms = { "list" }, each = { forms = { "text" }, refers = "joint" },
          doc = "joints that the water fills: it presses on both lips, and contact carries the rest" },
        { key = "unit_weight", forms = { "number" }, dimension = "N/m^3",
          range = { above = 0 }, usual = { from = 9.5e3, to = 1.1e4 },
          doc = "weight of the water by volume; 9.81 kN/m^3 if neither this nor the density is said" },
        { key = "density", forms = { "number" }, dimension = "kg/m^3",
          range = { above = 0 }, usual = { from = 950, to = 1100 },
          doc = "instead of unit_weight; times 9.80665 m/s^2, whatever gravity the stage says" },
      },
      alternatives = { { "unit_weight", "density", least = 0 }, { "on", "joints", least = 1, most = 2 } } },
  },
  extends = {
    stage = {
      { key = "water", forms = { "object", "list", "boolean" }, kind = "water",
        each = { forms = { "object" }, kind = "water" },
        doc = "water against faces: Water { level, on } or a list of them; false: none" },
    },
  },
  effects = {
    { name = "water", called_by = { "stage.water" }, nonlinear = false,
      doc = "Hydrostatic pressure on the faces named, integrated exactly over their wet part. "
         .. "Water acts on faces only: no seepage, no uplift unless a joint, lip or base is named.",
      left_out = "Water on faces: it matters when a reservoir, tailwater or water in a joint stands against "
              .. "the body; its thrust grows with the square of the depth." },
  },
}
