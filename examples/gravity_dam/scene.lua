-- Koyna dam on rock: own weight, then the reservoir.
local u = units
local profiles = require "dam_profiles"

local size  = param { "size", default = 3*u.m, doc = "cell size in the dam" }
local level = param { "level", default = 91.75*u.m, doc = "reservoir level above the dam's base" }

local concrete = material.elastic { E = 31*u.GPa, nu = 0.2, density = 2643*u.kg/u.m^3 }
local rock     = material.elastic { E = 31*u.GPa, nu = 0.2, density = 0*u.kg/u.m^3 }   -- long settled

local dam = profiles.koyna { material = concrete }
local reach, depth = 100, 100

return Scene {
  title = "Koyna dam on rock",
  plane = "strain",
  geometry = {
    dam  = Polygon(dam),
    rock = Polygon { {-reach,-depth,"bottom"}, {70+reach,-depth,"right"}, {70+reach,0,"ground"}, {0,0},
                     {-reach,0,"left"}, material = rock },
  },
  mesh = mesh.voronoi { size = { dam = size, rock = 3*size }, seed = 1 },
  element = "vem",
  supports = { ["rock.bottom"] = "xy", ["rock.left"] = "x", ["rock.right"] = "x" },
  stages = {
    Stage { "own weight", gravity = true },
    Stage { "reservoir", water = Water { level = level, on = { "dam.upstream" } } },
  },
  outputs = {
    sections = {
      base  = Section { edge = "dam.base" },          -- from heel to toe
      waist = Section { {0,30}, {47,30} },         -- from face to face; the air beyond does not count
      neck  = Section { {0,66.5}, {19.25,66.5} },     -- where the downstream face breaks
    },
    pictures = { "s3", "crosses", "sections" },
    probes = {
      crest = { "displacement", at = {0,103} },
      neck  = { "displacement", "stress", at = {19.25,66.5} },
      heel  = { "displacement", "stress", at = {0,0} },
      toe   = { "displacement", "stress", at = {70,0} },
    },
  },
}
