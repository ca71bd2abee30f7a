-- A closed, inclined crack that slips under uniaxial compression; or an open one under pressure inside.
local u = units
local case = param { "case", default = "slip" }
local size = param { "size", default = 20.0, doc = "half side of the square" }
local fine = param { "fine", default = 0.1 }
local order = param { "order", default = 1 }
local enforce = param { "enforce", default = "lagrange" }
local K, G = 16.67*u.GPa, 10*u.GPa
local rock = material.elastic { E = 9*K*G/(3*K+G), nu = (3*K-2*G)/(2*(3*K+G)) }
local a = case == "slip" and math.rad(20) or 0
local c, s = math.cos(a), math.sin(a)
local L = size
return Scene {
  title = "Crack", plane = "strain",
  geometry = { rock = Rectangle { from = {-L,-L}, to = {L,L}, material = rock } },
  joints = { crack = Joint { path = { {-s, -c}, {s, c} }, friction = contact.coulomb { friction_angle = 30*u.deg }, enforce = enforce } },
  mesh = mesh.gmsh { size = L/8, refine = { { joint = "crack", size = fine, radius = 0.3 } } },
  element = "vem", order = order,
  supports = { ["rock.bottom"] = "y", foot = Support { at = {0,-L}, fix = "xy" } },
  stages = { case == "slip" and Stage { "load", pressures = { ["rock.top"] = 100*u.MPa } } or
    Stage { "load", pressures = { ["crack.left"] = 2*u.MPa, ["crack.right"] = 2*u.MPa } } },
}
