-- Cross-sections of dams as corners for Polygon: metres, the heel at (0, 0), the reservoir on the left.
-- Edges: base, downstream, crest, upstream.
local profiles = {}

-- Koyna dam: tallest non-overflow monolith. Height 103 m, base 70 m, crest 14.8 m; the upstream face upright,
-- the downstream face with a break at 66.5 m, where the section is 19.25 m thick.
-- A. K. Chopra, P. Chakrabarti, The Koyna earthquake and the damage to Koyna Dam,
-- Bulletin of the Seismological Society of America 63 (1973) 381-397; simplified to a vertical upstream face
-- as is usual since.
function profiles.koyna(with)
  return {
    {0, 0, "base"}, {70, 0, "downstream"}, {19.25, 66.5, "downstream"}, {14.8, 103, "crest"}, {0, 103, "upstream"},
    material = with.material,
  }
end

return profiles
