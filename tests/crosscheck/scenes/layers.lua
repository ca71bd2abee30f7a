-- Two layers stretched alike, ν = 0: the stress along the layers jumps as their moduli do. With a joint between
-- them, pressed together and pushed along, what crosses it is what is put on.
local u = units
local jointed = param { "joint", default = false, doc = "a joint between the layers, and pressure" }
local order   = param { "order", default = 1, doc = "order of the element" }
local soft  = material.elastic { E = 1*u.GPa, nu = 0 }
local stiff = material.elastic { E = 3*u.GPa, nu = 0 }
local stretched = Stage { "stretch" }
local pressed = Stage { "press", pressures = { ["upper.top"] = function(x, y) return 1e6*(1 + x/4) end },
                        tractions = { ["upper.right"] = { x = -0.2*u.MPa } } }

return Scene {
  title = "Two layers",
  plane = "stress",
  geometry = {
    lower = Polygon { {0,0,"bottom"}, {4,0,"right"}, {4,1,"border"}, {0,1,"left"}, material = soft },
    upper = Polygon { {0,1,"border"}, {4,1,"right"}, {4,2,"top"}, {0,2,"left"}, material = stiff },
  },
  joints = jointed and { bed = Joint { between = { "upper", "lower" }, friction = "none",
                                       enforce = contact.penalty { factor = 100 } } } or {},
  mesh = mesh.voronoi { size = 0.3, seed = 2 },
  element = "vem", order = order,
  supports = jointed and { ["lower.bottom"] = "xy", corner = Support { at = {0,2}, fix = "x" } } or
             { ["lower.left"] = "x", ["upper.left"] = "x", ["lower.bottom"] = "y",
               ["lower.right"] = { ux = 4*u.mm }, ["upper.right"] = { ux = 4*u.mm } },
  stages = { jointed and pressed or stretched },
  outputs = {
    fields = { "displacement" },
    sections = {
      across = Section { {1.7,0}, {1.7,2} },
      upper  = Section { {1.7,1}, {1.7,2} },
      border = Section { {0,1}, {4,1} },
      backward = Section { {4,1}, {0,1} },
      edge   = Section { edge = "upper.border" },
    },
  },
}
