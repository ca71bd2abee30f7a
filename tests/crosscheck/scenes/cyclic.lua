-- A joint of given stiffness across a specimen, whose middle part slips under a cycle of axial displacement.
-- Olsson (1982), Brady et al. (1985): three slopes of force against displacement.
local u = units
local size = param { "size", default = 0.05 }
local enforce = param { "enforce", default = "lagrange" }
local E, W, H, K = 88.9*u.GPa, 1*u.m, 2*u.m, 220*u.GPa/u.m
local rock = material.elastic { E = E, nu = 0.26 }
local half = 0.27*math.cos(math.rad(45))
local function part(from, to, angle)
  return Joint { path = { from, to }, normal_law = contact.linear { stiffness = K },
                 friction = contact.coulomb { friction_angle = angle, stiffness = K }, enforce = enforce }
end
local a, b, c, d = {0,0.5}, {0.5-half,1-half}, {0.5+half,1+half}, {1,1.5}
local function push(name, mm)
  return Stage { name, steps = 4, supports = { ["rock.bottom"] = "y", foot = Support { at = {0.5,0}, fix = "x" },
                                   ["rock.top"] = Support { uy = -mm*u.mm } } }
end
return Scene {
  title = "Slipping joint under a load cycle", plane = "stress",
  geometry = { rock = Rectangle { from = {0,0}, to = {W,H}, material = rock } },
  joints = { lower = part(a, b, 75*u.deg), middle = part(b, c, 16*u.deg), upper = part(c, d, 75*u.deg) },
  mesh = mesh.voronoi { size = size, seed = 3 }, element = "vem", order = 1,
  supports = { ["rock.bottom"] = "y", foot = Support { at = {0.5,0}, fix = "x" } },
  stages = { push("a1", 1.0), push("a2", 2.0), push("b1", 1.8), push("b2", 1.4), push("c1", 0.8), push("c2", 0.4) },
}
