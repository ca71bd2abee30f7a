-- The contact patch test, three times: 1 MPa on bodies that meet along a slope, with points that do not match.
local u = units
local rock = material.elastic { E = 1*u.GPa, nu = 0.3 }
local slope = math.tan(math.rad(20))
local geometry, joints, supports, pressures, size = {}, {}, {}, {}, {}

local function pair(name, left, pairing)
  local right, lower, upper = left + 2, name .. "_lower", name .. "_upper"
  geometry[lower] = Polygon { {left,0,"bottom"}, {right,0,"side"}, {right,1+2*slope,"face"}, {left,1,"left"}, material = rock }
  geometry[upper] = Polygon { {left,1,"face"}, {right,1+2*slope,"side"}, {right,3,"top"}, {left,3,"left"}, material = rock }
  joints[name] = Joint { faces = { upper .. ".face", lower .. ".face" }, pairing = pairing, enforce = contact.lagrange {},
                         friction = contact.coulomb { friction_angle = 70*u.deg } }
  size[upper], size[lower] = 0.25, 0.25/2^0.5
  supports[lower .. ".bottom"] = "y"
  supports[name .. "_foot"] = Support { at = {left,0}, fix = "x" }
  supports[name .. "_head"] = Support { at = {left,3}, fix = "x" }
  pressures[upper .. ".top"] = 1*u.MPa
end
pair("mortar", 0, contact.mortar {})
pair("node_insertion", 2.5, contact.node_insertion {})
pair("node_to_segment", 5, contact.node_to_segment {})

return Scene {
  title = "Contact patch test", plane = "strain",
  geometry = geometry, joints = joints, mesh = mesh.voronoi { size = size, seed = 5 }, supports = supports,
  stages = { Stage { "press", pressures = pressures } },
  outputs = { fields = { "stress" } },
}
