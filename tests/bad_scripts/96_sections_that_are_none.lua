-- expect 21: needs at least 2 points, got 1
-- expect 22: two neighbouring points of the section coincide
-- expect 23: the section ends where it begins
-- expect 24: there is no edge 'rock.botom'
-- expect: did you mean 'rock.bottom'?
-- expect 25: by points or by an edge, not by both
-- expect 26: needs two points or more, or an edge
-- expect 27: unknown key 'edgee'
-- found by check
local u = units
local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }
return Scene {
  title = "A block of rock",
  plane = "strain",
  geometry = { rock = Rectangle { from = {0,0}, to = {10,5}, material = rock } },
  mesh = mesh.structured { cells = {4,2} },
  element = "vem",
  supports = { ["rock.bottom"] = "xy" },
  stages = { Stage { "self-weight", gravity = true } },
  outputs = { sections = {
    one    = Section { {0,0} },
    twice  = Section { {0,0}, {5,1}, {5,1} },
    closed = Section { {0,0}, {5,0}, {5,5}, {0,0} },
    base   = Section { edge = "rock.botom" },
    both   = Section { {0,0}, {5,0}, edge = "rock.bottom" },
    none   = Section {},
    wrong  = Section { edgee = "rock.bottom" },
  } },
}
