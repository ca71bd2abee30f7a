-- A block is pushed far along a rough base, over many of its cells, by steps of one size and then of another,
-- and back. Lips are paired anew in every step.
local pairing = param { "pairing", default = "mortar" }
local mu = param { "mu", default = 0.5 }
local order = param { "order", default = 1 }
local steps = param { "steps", default = 4, doc = "to 1.7 m" }
local last = param { "last", default = 1, doc = "from there to 2 m" }
local rock = material.elastic { E = 10e9, nu = 0.2 }
local function stage(name, far, count)
  return Stage { name, steps = count, supports = { ["base.bottom"] = "xy", ["block.top"] = Support { ux = far } } }
end

return Scene {
  title = "A block slides along a base", plane = "strain",
  geometry = {
    base = Polygon { {0,0,"bottom"}, {5,0}, {5,1,"face"}, {0,1}, material = rock },
    block = Polygon { {1,1,"foot"}, {2,1,"front"}, {2,1.5,"top"}, {1,1.5,"back"}, material = rock },
  },
  joints = { bed = Joint { faces = { "block.foot", "base.face" }, sliding = "finite", pairing = pairing, slave = "block",
    enforce = "lagrange", friction = contact.coulomb { friction_angle = math.atan(mu) } } },
  mesh = mesh.voronoi { size = 0.2, seed = 2 }, element = "vem", order = order,
  supports = { ["base.bottom"] = "xy" },
  stages = {
    Stage { "press", pressures = { ["block.top"] = 1e6 }, supports = { ["base.bottom"] = "xy" } },
    stage("push", 1.7, steps), stage("on", 2, last), stage("back", 1.4, steps),
  },
  outputs = { fields = { "displacement" } },
}
