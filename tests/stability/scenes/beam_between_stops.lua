-- A cantilever is bent down at its tip: two stops below it, and one above between them and the tip. Stops press
-- each other open, so that the status of all points together comes round to the first one, all open.
local rule = param { "rule", default = "worst_point" }
local steps = param { "steps", default = 1 }
local enforce = param { "enforce", default = "lagrange" }
local level = param { "level", default = 2.0, doc = "gap of the upper stop [mm]" }
local rock = material.elastic { E = 10e9, nu = 0.25 }
local width, depth = 0.1, 0.2
local function joint(name)
  return Joint { faces = { "beam." .. name, name .. ".face" }, friction = "none", pairing = "mortar", enforce = enforce }
end
local function below(x, gap)
  return Polygon { {x,-gap - 0.2,"far"}, {x + width,-gap - 0.2}, {x + width,-gap,"face"}, {x,-gap}, material = rock }
end
local top = depth + level/1000

return Scene {
  title = "A beam between three stops", plane = "strain",
  geometry = {
    beam = Polygon { {0,0,"under"}, {2.4,0,"first"}, {2.5,0,"between"}, {2.7,0,"second"}, {2.8,0,"over"}, {4,0,"tip"},
      {4,depth,"upper"}, {3.3,depth,"third"}, {3.2,depth,"back"}, {0,depth,"root"}, material = rock },
    first = below(2.4, 7.65e-3), second = below(2.7, 1.65e-3),
    third = Polygon { {3.2,top,"face"}, {3.3,top}, {3.3,top + 0.2,"far"}, {3.2,top + 0.2}, material = rock },
  },
  joints = { one = joint "first", two = joint "second", three = joint "third" },
  mesh = mesh.structured { size = 0.1 },
  element = "vem", order = 2, cycle_rule = rule,
  supports = { ["beam.root"] = "xy", ["first.far"] = "xy", ["second.far"] = "xy", ["third.far"] = "xy" },
  stages = { Stage { "bend", steps = steps, tractions = { ["beam.tip"] = Traction { y = -43e3 } } } },
  outputs = { fields = { "displacement" } },
}
