return {
  name = "contact",
  doc = "Joints whose lips meet: pairing, normal law, friction and enforcement, each chosen by one word.",
  provides = {
    { kind = "pairing", name = "node_to_segment", constructor = "contact.node_to_segment",
      doc = "Each slave point against the edge of the master lip that it faces, in one pass. Exact where the "
         .. "points of both lips match, as they do in joints that split a mesh.",
      parameters = {
        { key = "weight", forms = { "text" }, choices = { "tributary", "equal" }, default = "tributary",
          numerical = true,
          doc = "length that a point stands for: half of its edges, or the mean edge for all (source paper)" },
      } },
    { kind = "normal_law", name = "unilateral",
      doc = "Lips press but do not pull: closed where the gap is 0 or less, free where it is open.",
      parameters = {} },
    { kind = "friction", name = "none", doc = "Frictionless: the lips slide freely.", parameters = {} },
    { kind = "enforcement", name = "penalty", constructor = "contact.penalty",
      doc = "Pressure proportional to the penetration.",
      parameters = {
        { key = "factor", forms = { "number" }, default = 100, numerical = true,
          range = { above = 0 }, usual = { from = 1, to = 1e6 },
          doc = "times E'/h of the softer side: the penetration is about pressure * h / (factor * E')" },
        { key = "stiffness", forms = { "number" }, dimension = "Pa/m", range = { above = 0 },
          doc = "pressure for each metre of penetration, whatever the mesh" },
      },
      alternatives = { { "factor", "stiffness", least = 0 } } },
  },
  extends = {
    joint = {
      { key = "friction", forms = { "object" }, kind = "friction",
        doc = "what resists sliding; required for every joint: \"none\"" },
      { key = "normal_law", forms = { "object" }, kind = "normal_law", default = "unilateral",
        doc = "when the lips are closed" },
      { key = "pairing", forms = { "object" }, kind = "pairing", default = "node_to_segment", numerical = true,
        doc = "how points of one lip find the other" },
      { key = "enforce", forms = { "object" }, kind = "enforcement", default = "penalty", numerical = true,
        doc = "how penetration is prevented" },
      { key = "slave", forms = { "text" },
        doc = "the lip whose points carry the contact, as joint.side (\"fault.upper\"; the side alone will do); "
             .. "nothing: the lip with more edges, the first of equals" },
    },
  },
  effects = {
    { name = "contact", called_by = { "scene.joints" }, nonlinear = true,
      doc = "Joints open and close: no tension across them, no penetration but the penalty's. Small sliding: "
         .. "points stay paired as in the undeformed mesh. Forces are those of the contact points: half a mesh edge "
         .. "at each welded tip has none.",
      left_out = "Contact in joints: the body is whole, and every border between regions bonded. It matters when "
              .. "faults, bedding or lift joints would open, slide or carry no tension." },
  },
}
