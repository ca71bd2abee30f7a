-- A block that only joints hold, or that nothing holds.
local held = param { "held", default = "squeezed", choices = { "squeezed", "fallen", "sliding", "pulled" } }
local mu = param { "mu", default = 0.5 }
local enforce = param { "enforce", default = "lagrange" }
local rock = material.elastic { E = 10e9, nu = 0.25, unit_weight = 25e3 }
local rough = contact.coulomb { friction_angle = math.atan(mu) }
local geometry, joints, supports, pressures
if held == "squeezed" then   -- between two walls that press on it with 100 kN: friction bears at most 2 mu 100 kN
  geometry = {
    left = Rectangle { from = {-0.5,0}, to = {0,1}, material = rock },
    block = Rectangle { from = {0,0}, to = {1,1}, material = rock },
    right = Rectangle { from = {1,0}, to = {1.5,1}, material = rock },
  }
  joints = { a = Joint { between = { "block", "left" }, friction = rough, enforce = enforce },
             b = Joint { between = { "block", "right" }, friction = rough, enforce = enforce } }
  supports = { ["left.left"] = "xy", ["right.bottom"] = "y", ["right.top"] = "y" }
  pressures = { ["right.right"] = 100e3 }
else   -- over the ground, 1 cm or nothing between them
  local y = held == "fallen" and 0.01 or 0
  geometry = {
    ground = Rectangle { from = {-1,-1}, to = {2,0}, material = rock },
    block = Rectangle { from = {0,y}, to = {1,1 + y}, material = rock },
  }
  joints = { a = Joint { faces = { "block.bottom", "ground.top" }, friction = "none", enforce = enforce, pairing = "mortar" } }
  supports = { ["ground.bottom"] = "xy", side = held ~= "sliding" and Support { edge = "block.left", fix = "x" } or nil }
  pressures = { ["block.top"] = held == "pulled" and -100e3 or nil, ["block.left"] = held == "sliding" and 1e3 or nil }
end

return Scene {
  title = "A floating block", plane = "strain", geometry = geometry, joints = joints,
  mesh = mesh.structured { size = 0.25 }, element = "vem", supports = supports,
  stages = { Stage { "weight", gravity = true, pressures = pressures } },
  outputs = { fields = { "displacement", "stress" } },
}
