-- What several laws of joints share.
local function stiffness(doc, required)
  return { key = "stiffness", forms = { "number" }, dimension = "Pa/m", required = required, range = { above = 0 },
           usual = { from = 1e7, to = 1e15 }, doc = doc }
end
local function cohesion(key, doc, default)
  return { key = key, forms = { "number" }, dimension = "Pa", range = { from = 0 }, default = default,
           usual = { from = 1, to = 1e8 }, doc = doc }
end
local function slip(key, doc)
  return { key = key, forms = { "number" }, dimension = "m", range = { from = 0 }, usual = { from = 1e-5, to = 1 },
           doc = doc }
end
local tensile_strength = { key = "tensile_strength", forms = { "number" }, dimension = "Pa", required = true,
                           range = { above = 0 }, usual = { from = 1e3, to = 1e8 },
                           doc = "Pull at which the lips part." }
local named_numbers = { key = "parameters", forms = { "table" }, doc = "Named numbers that the function gets as p." }

return {
  name = "contact",
  doc = "Joints whose lips meet: pairing, normal law, friction and enforcement, each chosen by one word.",
  provides = {
    { kind = "pairing", name = "node_to_segment", constructor = "contact.node_to_segment",
      doc = "Each slave point against the edge of the master lip that it faces. Exact where the points of both "
         .. "lips match, as they do in joints that split a mesh; rough where they do not.",
      parameters = {
        { key = "passes", forms = { "integer" }, default = 1, numerical = true, range = { from = 1, to = 2 },
          doc = "1: the slave lip's points carry all; 2: those of both lips half each" },
        { key = "weight", forms = { "text" }, choices = { "tributary", "equal" }, default = "tributary",
          numerical = true,
          doc = "length that a point stands for: half of its edges, or the mean edge for all (source paper)" },
      } },
    { kind = "pairing", name = "node_insertion", constructor = "contact.node_insertion",
      doc = "Points of each lip become hanging points of the other, and nodes pair with nodes: exact for a uniform "
         .. "pressure. For elements that take polygons.",
      parameters = {
        { key = "reach", forms = { "number" }, default = 1, numerical = true, range = { above = 0 },
          doc = "lips farther apart than this many edge lengths are not matched" },
      } },
    { kind = "pairing", name = "mortar", constructor = "contact.mortar",
      doc = "Segment to segment: means of the gap over the slave lip's shape functions (dual multipliers). Passes a "
         .. "uniform pressure exactly whatever the points of both lips, for elements of every order.",
      parameters = {} },
    { kind = "normal_law", name = "unilateral",
      doc = "Lips press but do not pull: closed where the gap is 0 or less, free where it is open.",
      parameters = {} },
    { kind = "normal_law", name = "linear", constructor = "contact.linear",
      doc = "A joint of constant stiffness. It pulls no more than its tensile strength, and not again once parted.",
      parameters = {
        stiffness("Pressure for each metre of closure, k_n.", true),
        { key = "tensile_strength", forms = { "number" }, dimension = "Pa", range = { from = 0 }, default = 0,
          usual = { from = 1e3, to = 1e8 }, doc = "Pull at which the lips part for good." },
      } },
    { kind = "normal_law", name = "tension_cut_off", constructor = "contact.tension_cut_off",
      doc = "Bonded lips that neither close nor open until they are pulled apart; then unilateral for good.",
      parameters = { tensile_strength } },
    { kind = "normal_law", name = "barton_bandis", constructor = "contact.barton_bandis_closure",
      doc = "Hyperbolic closure of rock joints: they stiffen as they close. No tension.",
      parameters = {
        stiffness("Pressure for each metre of closure at no pressure, k_ni.", true),
        { key = "greatest_closure", forms = { "number" }, dimension = "m", required = true, range = { above = 0 },
          usual = { from = 1e-6, to = 1e-2 }, doc = "Closure that no pressure reaches, V_m." },
      } },
    { kind = "normal_law", name = "cohesive", constructor = "contact.cohesive",
      doc = "A healed joint that tears: its pull falls linearly with the opening. Torn lips press, and pull less.",
      parameters = {
        stiffness("Of the lips while they are whole, and in compression.", true), tensile_strength,
        { key = "fracture_energy", forms = { "number" }, dimension = "N/m", required = true,
          range = { above = 0 }, usual = { from = 1e-1, to = 1e4 },
          doc = "Energy that tears one square metre, more than tensile_strength^2/(2 stiffness)." },
      } },
    { kind = "normal_law", name = "lua", constructor = "contact.lua_normal",
      doc = "A normal law written in the scenario, for trying ideas; three calls of the script a point and iteration.",
      parameters = {
        { key = "pressure", forms = { "function" }, required = true,
          doc = "function(opening, p) that returns the pressure [Pa], positive in compression; opening < 0: closure. " ..
                "With variables: function(opening, state, p) that returns the pressure and the new state as a list." },
        { key = "variables", forms = { "integer" }, default = 0, range = { from = 0, to = 3 },
          doc = "Numbers in the state, all 0 at first." },
        named_numbers,
      } },
    { kind = "friction", name = "none", doc = "Frictionless: the lips slide freely.", parameters = {} },
    { kind = "friction", name = "coulomb", constructor = "contact.coulomb",
      doc = "Coulomb's friction with cohesion, residual strength after slip, and dilation.",
      parameters = {
        { key = "friction_angle", forms = { "number" }, required = true, range = { from = 0 },
          doc = "0 to below 90 degrees: 35*units.deg." },
        cohesion("cohesion", "Shear strength without pressure.", 0),
        { key = "residual_friction_angle", forms = { "number" }, range = { from = 0 },
          doc = "After softening_slip, at most friction_angle. Left out: as friction_angle." },
        cohesion("residual_cohesion", "After softening_slip, at most cohesion. Left out: as cohesion."),
        slip("softening_slip", "Slip over which the strength falls linearly to its residual value; 0: at once."),
        { key = "dilation_angle", forms = { "number" }, range = { from = 0 },
          doc = "Angle at which slip opens the lips, at most the friction that is left: 5*units.deg. Left out: none." },
        { key = "dilation_slip", forms = { "number" }, dimension = "m", range = { above = 0 },
          usual = { from = 1e-5, to = 1 },
          doc = "Slip over which dilation decays to 1/e. Left out: it does not." },
        stiffness("Shear for each metre of slip while the lips stick, k_s. Left out: they stick exactly."),
      } },
    { kind = "friction", name = "barton_bandis", constructor = "contact.barton_bandis",
      doc = "Peak strength of rough joints by Barton: pressure * tan(residual_angle + JRC log10(JCS/pressure)).",
      parameters = {
        { key = "JRC", forms = { "number" }, required = true, range = { from = 0, to = 40 },
          usual = { from = 0, to = 20 }, doc = "Joint roughness coefficient at the joint's own length: degrees." },
        { key = "JCS", forms = { "number" }, dimension = "Pa", required = true, range = { above = 0 },
          usual = { from = 1e6, to = 5e8 }, doc = "Compressive strength of the joint's walls." },
        { key = "residual_angle", forms = { "number" }, required = true, range = { from = 0 },
          doc = "Friction of the worn joint, 0 to below 70 degrees: 30*units.deg." },
        { key = "dilation", forms = { "boolean" }, default = false,
          doc = "Slip opens the lips at half the angle of roughness, JRC/2 log10(JCS/pressure)." },
        stiffness("Shear for each metre of slip while the lips stick, k_s. Left out: they stick exactly."),
      } },
    { kind = "friction", name = "lua", constructor = "contact.lua_friction",
      doc = "A friction law written in the scenario, for trying ideas; 5 to 14 calls of the script a point and iteration.",
      parameters = {
        { key = "strength", forms = { "function" }, required = true,
          doc = "function(pressure, path, p) that returns the shear strength [Pa] after a slip of path [m]." },
        { key = "dilation", forms = { "function" },
          doc = "function(pressure, path, p) that returns the opening [m] made by a slip from 0 to path." },
        named_numbers,
        stiffness("Shear for each metre of slip while the lips stick, k_s. Left out: they stick exactly."),
      } },
    { kind = "driven_joint", name = "contact_point",
      doc = "A point of a joint, led by `ashlar drive`.",
      parameters = {
        { key = "normal_law", forms = { "object" }, kind = "normal_law", default = "unilateral",
          doc = "what presses, and pulls, across the lips" },
        { key = "friction", forms = { "object" }, kind = "friction", required = true, doc = "what resists sliding" },
      } },
    { kind = "cycle_rule", name = "worst_point",
      doc = "Once the statuses of joints (open, stick, slip) repeat themselves, points change one by one: the one that is wrong by the most energy.",
      parameters = {} },
    { kind = "cycle_rule", name = "first_point",
      doc = "Once the statuses of joints (open, stick, slip) repeat themselves, points change one by one: the first of those that are wrong (Murty).",
      parameters = {} },
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
    { kind = "enforcement", name = "lagrange", constructor = "contact.lagrange",
      doc = "Lagrange multipliers: tractions are unknowns, and lips that touch do not penetrate at all.",
      parameters = {} },
    { kind = "enforcement", name = "augmented_lagrange", constructor = "contact.augmented_lagrange",
      doc = "A penalty whose pressures are kept as multipliers and built up until next to nothing penetrates.",
      parameters = {
        { key = "factor", forms = { "number" }, default = 100, numerical = true,
          range = { above = 0 }, usual = { from = 1, to = 1e6 }, doc = "times E'/h of the softer side, to begin with" },
        { key = "cap", forms = { "number" }, default = 1e6, numerical = true, range = { above = 0 },
          doc = "to which the factor may grow, tenfold at a time, where multipliers build up slowly" },
        { key = "tolerance", forms = { "number" }, default = 1e-8, numerical = true,
          range = { above = 0 }, usual = { from = 1e-12, to = 1e-3 }, doc = "penetration over mesh size to be reached" },
      } },
  },
  extends = {
    scene = {
      { key = "cycle_rule", forms = { "object" }, kind = "cycle_rule", default = "worst_point", numerical = true,
        doc = "which point of the joints changes its status alone, once statuses have come round in a cycle" },
    },
    joint = {
      { key = "friction", forms = { "object" }, kind = "friction",
        doc = "what resists sliding; required for every joint: \"none\", contact.coulomb { … }" },
      { key = "normal_law", forms = { "object" }, kind = "normal_law", default = "unilateral",
        doc = "what presses, and pulls, across the lips" },
      { key = "pairing", forms = { "object" }, kind = "pairing", default = "node_to_segment", numerical = true,
        doc = "how points of one lip find the other" },
      { key = "enforce", forms = { "object" }, kind = "enforcement", default = "penalty", numerical = true,
        doc = "how penetration is prevented" },
      { key = "sliding", forms = { "text" }, choices = { "small", "finite" }, default = "small",
        doc = "finite: lips that move far along each other are paired anew before each step (say steps in the stages); "
           .. "small: points stay paired as drawn" },
      { key = "slave", forms = { "text" },
        doc = "the lip whose points carry the contact, as joint.side (\"fault.upper\"; the side alone will do); "
             .. "nothing: the lip with more edges, the first of equals" },
    },
  },
  effects = {
    { name = "contact", called_by = { "scene.joints" }, nonlinear = true,
      doc = "Joints open, close and slip by their laws; no penetration but the penalty's. Points stay paired as in the "
         .. "undeformed mesh unless a joint says sliding = \"finite\". Forces are those of the contact points: half a mesh edge "
         .. "at each welded tip has none.",
      left_out = "Contact in joints: the body is whole, and every border between regions bonded. It matters when "
              .. "faults, bedding or lift joints would open, slide or carry no tension." },
  },
}
