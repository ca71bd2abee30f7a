-- A block with an uneven foot is moved down and sideways onto rough ground. Of the points that touch, two flip
-- together between two statuses that call for each other.
local mu = param { "mu", default = 3.0, doc = "coefficient of friction" }
local rule = param { "rule", default = "worst_point" }
local rock = material.elastic { E = 10e9, nu = 0.25 }

return Scene {
  title = "A toothed joint", plane = "strain",
  geometry = {
    ground = Rectangle { from = {0,0}, to = {4,1}, material = rock },
    block = Polygon { {1,1 + 90e-6,"base"}, {5/3,1 + 20e-6,"base"}, {7/3,1 + 50e-6,"base"}, {3,1 + 50e-6,"right"},
      {3,1.5,"top"}, {1,1.5,"left"}, material = rock },
  },
  joints = { seam = Joint { faces = { "block.base", "ground.top" }, pairing = "mortar", slave = "block", enforce = "lagrange",
    friction = contact.coulomb { friction_angle = math.atan(mu) } } },
  mesh = mesh.structured { size = 0.5 },
  element = "vem", cycle_rule = rule,
  supports = { ["ground.bottom"] = "xy" },
  stages = { Stage { "press", supports = { ["ground.bottom"] = "xy",
    ["block.top"] = Support { ux = -87e-6, uy = -100e-6 } } } },
  outputs = { fields = { "displacement" } },
}
