return {
  name = "loads",
  doc = "Loads that the scene gives by numbers or functions: tractions, pressures, forces, couples.",
  provides = {
    { kind = "traction", name = "traction", constructor = "Traction",
      doc = "Traction on an edge by its components along x and y.",
      parameters = {
        { key = "x", forms = { "number", "function" }, dimension = "Pa",
          doc = "along x: a number, or a function of (x, y); nothing: 0" },
        { key = "y", forms = { "number", "function" }, dimension = "Pa",
          doc = "along y: a number, or a function of (x, y); nothing: 0" },
      },
      alternatives = { { "x", "y", most = 2 } } },
    { kind = "force", name = "force", constructor = "Force",
      doc = "A force at the mesh point nearest to a place, for the whole thickness of the model.",
      parameters = {
        { key = "at", forms = { "point" }, dimension = "m", required = true, doc = "the place" },
        { key = "x", forms = { "number" }, dimension = "N", doc = "along x; nothing: 0" },
        { key = "y", forms = { "number" }, dimension = "N", doc = "along y; nothing: 0" },
        { key = "lip", forms = { "text" }, refers = "lip",
          doc = "at a joint: the lip that carries it, such as \"fault.upper\"" },
      },
      alternatives = { { "x", "y", most = 2 } } },
    { kind = "couple", name = "couple", constructor = "Couple",
      doc = "A moment by two opposite forces at the mesh points nearest to two places, perpendicular to the "
         .. "line between these points, for the whole thickness of the model.",
      parameters = {
        { key = "between", forms = { "list" }, required = true,
          each = { forms = { "point" }, dimension = "m" }, doc = "the two places { {x1, y1}, {x2, y2} }" },
        { key = "moment", forms = { "number" }, dimension = "N*m", required = true,
          doc = "the moment, counter-clockwise positive" },
      } },
  },
  extends = {
    stage = {
      { key = "tractions", forms = { "map", "boolean" }, refers = "edge",
        each = { forms = { "object" }, kind = "traction" },
        doc = "tractions on border edges by their names: { [\"dam.crest\"] = { x = …, y = … } }; false: none" },
      { key = "pressures", forms = { "map", "boolean" }, refers = "edge",
        each = { forms = { "number", "function", "list" }, dimension = "Pa", each = { forms = { "table" } } },
        doc = "pressures on border edges by their names, compression positive: a number, a function of (x, y), "
           .. "or a table { {y, p}, {y, p}, … } with straight lines between its rows; false: none" },
      { key = "forces", forms = { "list", "boolean" }, each = { forms = { "object" }, kind = "force" },
        doc = "forces at points: { Force { at, x, y }, … }; false: none" },
      { key = "couples", forms = { "list", "boolean" }, each = { forms = { "object" }, kind = "couple" },
        doc = "moments: { Couple { between, moment }, … }; false: none" },
    },
  },
  effects = {
    { name = "loads", called_by = { "stage.tractions", "stage.pressures", "stage.forces", "stage.couples" },
      nonlinear = false,
      doc = "Tractions and pressures on edges, forces and couples at points, as the scene gives them.",
      left_out = "Given tractions, pressures, forces and couples: they matter when something outside the "
              .. "model (traffic, gates, neighbouring ground) acts on it." },
  },
}
