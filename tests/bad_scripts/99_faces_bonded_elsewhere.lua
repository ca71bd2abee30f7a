-- expect 12: 'dam' and 'rock' meet by contact, but they are bonded along another border from (4, 5) to (6, 5)
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block on rock",
  plane = "strain",
  geometry = {
    rock = Rectangle { from = {0,0}, to = {10,5}, material = rock },
    dam = Rectangle { from = {4,5}, to = {6,8}, material = rock },
  },
  joints = { lift = Joint { friction = "none", faces = {"dam.left", "rock.top"} } },
  mesh = mesh.voronoi { size = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
}
