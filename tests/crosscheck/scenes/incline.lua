-- A block on an inclined base, held by friction alone: it sticks below tan ψ = tan φ, slides above, and topples
-- where its weight leaves the base.
local u = units
local slope = param { "slope", default = 29.99, doc = "angle of the base in degrees" }
local angle = param { "friction_angle", default = 30.0, doc = "in degrees" }
local height = param { "height", default = 1.0, doc = "of the block in metres; it is 1 m wide" }
local enforce = param { "enforce", default = "lagrange" }
local rock = material.elastic { E = 10*u.GPa, nu = 0.2, unit_weight = 25*u.kN/u.m^3 }
local c, s = math.cos(slope*u.deg), math.sin(slope*u.deg)
local function at(x, y, name) return { c*x - s*y, s*x + c*y, name } end
return Scene {
  title = "Block on an incline", plane = "strain",
  geometry = {
    base = Polygon { at(0,0,"bottom"), at(5,0), at(5,1), at(3,1), at(2,1), at(0,1), material = rock },
    block = Polygon { at(2,1), at(3,1), at(3,1+height), at(2,1+height), material = rock },
  },
  joints = { bed = Joint { between = { "block", "base" }, enforce = enforce,
                           friction = contact.coulomb { friction_angle = angle*u.deg } } },
  mesh = mesh.voronoi { size = 0.15, seed = 3 }, element = "vem", order = 1,
  supports = { ["base.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
}
