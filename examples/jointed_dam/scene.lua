-- Dam on a jointed foundation: self-weight first, then the reservoir fills.
local u = units
local cells = param { "cells", default = 2000, doc = "number of cells (gmsh: about)" }
local kind  = param { "mesh", default = "voronoi", choices = { "voronoi", "quads", "triangles" }, doc = "shape of cells" }
local level = param { "level", default = 15*u.m, doc = "reservoir level above the foundation's base" }
local jointed = param { "jointed", default = true, doc = "cut the rock along the fault; else it is whole" }
local pairing = param { "pairing", default = "one_pass", choices = { "one_pass", "two_passes", "node_insertion", "mortar" },
                        doc = "how the lips' points find each other: node to segment (one, two passes), or as it says" }
local enforce = param { "enforce", default = "penalty", choices = { "penalty", "augmented_lagrange", "lagrange" },
                        doc = "how penetration is prevented" }
local factor  = param { "factor", default = 100, doc = "of the penalty, times E'/h; the augmented one begins with it" }
local filled  = param { "filled", default = true, doc = "let the water act; else the second stage is as the first" }

local rock = material.elastic { E = 10*u.GPa, nu = 0.3, unit_weight = 24*u.kN/u.m^3 }

local area = (25*10 + (5 + 2)/2*5)*u.m^2
local meshes = {
  voronoi   = mesh.voronoi { cells = cells, seed = 7 },
  quads     = mesh.gmsh { cells = "quads", size = (area/cells)^0.5 },
  triangles = mesh.gmsh { cells = "triangles", size = (4/3^0.5*area/cells)^0.5 },
}

local pairings = {
  one_pass = contact.node_to_segment {}, two_passes = contact.node_to_segment { passes = 2 },
  node_insertion = contact.node_insertion {}, mortar = contact.mortar {},
}
local enforcements = {
  penalty = contact.penalty { factor = factor }, lagrange = contact.lagrange {},
  augmented_lagrange = contact.augmented_lagrange { factor = factor },
}

return Scene {
  title = "Dam on a jointed foundation",
  plane = "strain",
  geometry = {   -- the third entry of a corner names the edge that starts there
    rock = Polygon { {0,0,"bottom"}, {25,0,"right"}, {25,10,"ground"}, {0,10,"left"}, material = rock },
    dam  = Polygon { {10,10,"base"}, {15,10,"downstream"}, {12,15,"crest"}, {10,15,"upstream"}, material = rock },
  },
  joints = jointed and {   -- open at the ground, welded at its tip; a corner at (7, 7) makes a mesh point there
    fault = Joint { path = { {4,10}, {7,7}, {10,4} }, sides = { "upper", "lower" },
                    friction = "none", pairing = pairings[pairing], enforce = enforcements[enforce] },
  } or {},
  mesh = meshes[kind],
  element = "vem",
  supports = { ["rock.bottom"] = "xy", ["rock.left"] = "xy", ["rock.right"] = "xy" },
  stages = {
    Stage { "self-weight", gravity = true },
    Stage { "reservoir", water = filled and Water { level = level, on = { "dam.upstream" }, unit_weight = 9.81*u.kN/u.m^3 } },
  },
  outputs = {
    probes = {
      crest = { "displacement", "stress", at = {10,15} },
      heel  = { "displacement", "stress", at = {10,10} },
      toe   = { "displacement", "stress", at = {15,10} },
      mouth_upper = { "displacement", at = {4,10}, lip = jointed and "fault.upper" or nil },
      mouth_lower = { "displacement", at = {4,10}, lip = jointed and "fault.lower" or nil },
      mid_upper = { "displacement", at = {7,7}, lip = jointed and "fault.upper" or nil },
      mid_lower = { "displacement", at = {7,7}, lip = jointed and "fault.lower" or nil },
    },
  },
}
