-- expect 10: joints 'seam' and 'crack' are 2 mm apart around (
-- expect: smaller cells there, of at most 20 mm, or one joint in place of both
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene { title = "A block on a block", plane = "strain",
  geometry = { low = Rectangle { from = {0,0}, to = {10,5}, material = rock },
    high = Rectangle { from = {0,5}, to = {10,8}, material = rock } },
  joints = {
    seam = Joint { faces = { "high.bottom", "low.top" }, friction = "none" },
    crack = Joint { friction = "none", path = { {3,5.002}, {7,5.002} } } },
  mesh = mesh.structured { size = 0.5 },
  element = "vem",
  supports = { ["low.bottom"] = "xy", ["high.left"] = "x" },
  stages = { Stage { "self-weight", gravity = true } },
}
