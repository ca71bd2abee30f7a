-- A thick tube under inner pressure, held lengthwise: Lamé while elastic, Hill once it yields. A quarter of its
-- cross-section in plane strain, or a slice of its half section turned about the axis.
local u = units
local plane   = param { "plane", default = "strain", choices = { "strain", "axisymmetric" }, doc = "which section" }
local element = param { "element", default = "vem", choices = { "vem", "fem" }, doc = "kind of element" }
local order   = param { "order", default = 2, doc = "its order" }
local cells   = param { "cells", default = "voronoi", choices = { "voronoi", "quads" }, doc = "shape of cells" }
local size    = param { "size", default = 0.1*u.m, doc = "of the cells" }
local yields  = param { "yields", default = false, doc = "yields at a shear strength of 10 MPa" }
local p       = param { "pressure", default = 10*u.MPa, doc = "inside" }
local E, nu = 20*u.GPa, 0.3
local wall = yields and material.mohr_coulomb { E = E, nu = nu, cohesion = 10*u.MPa, friction = 0*u.deg, dilation = 0*u.deg }
             or material.elastic { E = E, nu = nu }
local flat = plane == "strain"
local section = flat
  and Polygon { {1,0,"low"}, {2,0,"outside", arc = { center = {0,0} }}, {0,2,"left"}, {0,1,"inside", arc = { center = {0,0} }},
                material = wall }
  or Rectangle { from = {1,0}, to = {2,0.5}, names = { "low", "outside", "high", "inside" }, material = wall }

-- Lame's solution, while elastic.
local q, e = p/u.Pa / 3, E/u.Pa
local function displacement(x, y)
  local r = math.sqrt(flat and x^2 + y^2 or x^2)
  local ur = (1 + nu)*q/e * ((1 - 2*nu)*r + 4/r)
  return ur * x/r, flat and ur * y/r or 0
end
local function stress(x, y)
  local r = math.sqrt(flat and x^2 + y^2 or x^2)
  local radial, hoop, along = q*(1 - 4/r^2), q*(1 + 4/r^2), 2*nu*q
  if not flat then return radial, along, 0, hoop end
  local c, s = x/r, y/r
  return radial*c^2 + hoop*s^2, radial*s^2 + hoop*c^2, (radial - hoop)*s*c, along
end
local known = not yields and { lame = Exact { displacement = displacement, stress = stress } } or {}

return Scene {
  title = "Thick tube under inner pressure", plane = plane,
  geometry = { wall = section },
  mesh = cells == "voronoi" and mesh.voronoi { size = size, seed = 5 } or mesh.structured { size = size },
  element = element, order = order,
  supports = flat and { ["wall.low"] = "y", ["wall.left"] = "x" } or { ["wall.low"] = "y", ["wall.high"] = "y" },
  stages = { Stage { "pressure", pressures = { ["wall.inside"] = p } } },
  outputs = {
    fields = { "displacement", "stress" },
    exact = known,
    probes = { inside = { "displacement", "stress", at = {1,0} }, outside = { "displacement", "stress", at = {2,0} } },
  },
}
