-- A block pressed on another over a rough joint, then pushed along it by its side or by a pressure on it.
-- Lengths times m, stresses times pa: other units.
local m  = param { "m", default = 1.0, doc = "what the unit of length is multiplied by" }
local pa = param { "pa", default = 1.0, doc = "what the unit of stress is multiplied by" }
local mu = param { "mu", default = 0.3, doc = "coefficient of friction" }
local enforce = param { "enforce", default = "lagrange" }
local move = param { "move", default = 0.0, doc = "how far the block's left side is pushed [m]; 0: not" }
local share = param { "share", default = 0.0, doc = "of the strength, pushed by a pressure on the left side" }
local back = param { "back", default = 0.0, doc = "the same in a stage after it" }
local one = param { "one", default = false, doc = "pressed and pushed in one stage" }
local steps = param { "steps", default = 1 }
local order = param { "order", default = 1 }
local jump = param { "jump", default = 1.0, doc = "how many times the strength is once slip begins" }
local rock = material.elastic { E = 10e9*pa, nu = 0.25 }
local q = 1e6*pa

local side = move ~= 0
local friction = mu == 0 and "none" or contact.coulomb { friction_angle = math.atan(mu) }
if jump ~= 1 then
  friction = contact.lua_friction { strength = function(p, path) return path > 0 and jump*mu*p or mu*p end }
end
local function stage(name, much, last)
  return Stage { name, steps = steps,
    supports = side and { ["ground.bottom"] = "xy", push = Support { edge = "block.left", ux = much*m } } or nil,
    pressures = { ["block.top"] = q, ["block.left"] = not side and much*mu*q*2/0.5 or nil } }
end
local stages = { not one and Stage { "press", pressures = { ["block.top"] = q } } or nil }
stages[#stages + 1] = stage("push", side and move or share)
if back ~= 0 then stages[#stages + 1] = stage("back", back) end

return Scene {
  title = "A pushed joint", plane = "strain",
  geometry = {
    ground = Rectangle { from = {0,0}, to = {4*m,1*m}, material = rock },
    block = Polygon { {1*m,1*m,"base"}, {3*m,1*m,"right"}, {3*m,1.5*m,"top"}, {1*m,1.5*m,"left"}, material = rock },
  },
  joints = { seam = Joint { faces = { "block.base", "ground.top" }, pairing = "node_insertion",
    friction = friction, enforce = enforce } },
  mesh = mesh.structured { size = 0.25*m },
  element = "vem", order = order,
  supports = { ["ground.bottom"] = "xy" },
  stages = stages,
  outputs = { fields = { "displacement", "stress" } },
}
