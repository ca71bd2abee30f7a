-- A square pressed evenly from all sides, cut by joints of mixed laws: each must carry the same pressure.
local cut = param { "cut", default = "X", choices = { "X", "rough X", "T", "rough T", "bent", "inner", "mouth", "through", "cell", "wall" } }
local enforce = param { "enforce", default = "lagrange" }
local pairing = param { "pairing", default = "node_to_segment" }
local edges = param { "edges", default = false, doc = "the left and lower edges are held; else three corners" }
local order = param { "order", default = 1 }
local rock = material.elastic { E = 10e9, nu = 0.25 }
local q = 1e6
local rough = contact.coulomb { friction_angle = math.atan(0.5) }
local stiff = contact.linear { stiffness = 1e11 }
local function joint(path, friction, law)
  return Joint { path = path, friction = friction, normal_law = law, enforce = enforce, pairing = pairing }
end
local joints = ({
  X = function() return { a = joint({ {0,0.7}, {2,1.2} }, "none"), b = joint({ {0.6,0}, {1.3,2} }, rough, stiff) } end,
  T = function() return { a = joint({ {0,0.7}, {2,1.2} }, rough), b = joint({ {1,0.95}, {1.3,2} }, "none") } end,
  ["rough X"] = function() return { a = joint({ {0,0.7}, {2,1.2} }, rough), b = joint({ {0.6,0}, {1.3,2} }, rough) } end,
  ["rough T"] = function() return { a = joint({ {0,0.7}, {2,1.2} }, rough), b = joint({ {1,0.95}, {1.3,2} }, rough) } end,
  bent = function() return { a = joint({ {0,0.7}, {0.9,1.3}, {2,1.2} }, rough) } end,
  inner = function() return { a = joint({ {0.53,0.71}, {1.37,1.13} }, "none") } end,
  mouth = function() return { a = joint({ {0,0.71}, {1.37,1.13} }, rough) } end,
  cell = function() return { a = joint({ {0,0.9}, {1.13,1.07} }, rough) } end,   -- in a mesh of rows and columns
  through = function() return { a = joint({ {0,0.71}, {2,1.13} }, "none") } end,
})[cut]

-- A wall of 3 by 3 single cells: every corner of every cell lies on joints.
local geometry, laws, count = { body = Rectangle { from = {0,0}, to = {2,2}, material = rock } }, { "none", rough }, 0
local sides = { left = { "body.left" }, bottom = { "body.bottom" }, right = { "body.right" }, top = { "body.top" } }
if cut == "wall" then
  geometry, joints, sides = {}, {}, { left = {}, bottom = {}, right = {}, top = {} }
  local function name(i, j) return "c" .. i .. j end
  for i = 1, 3 do for j = 1, 3 do
    geometry[name(i,j)] = Rectangle { from = {(i-1)*2/3, (j-1)*2/3}, to = {i*2/3, j*2/3}, material = rock }
    for _, next in ipairs { { i+1, j }, { i, j+1 } } do
      if next[1] <= 3 and next[2] <= 3 then
        count = count + 1
        joints["j" .. count] = Joint { between = { name(i,j), name(next[1],next[2]) }, friction = laws[count % 2 + 1], enforce = enforce,
                                       pairing = pairing }
      end
    end
    if i == 1 then table.insert(sides.left, name(i,j) .. ".left") end
    if i == 3 then table.insert(sides.right, name(i,j) .. ".right") end
    if j == 1 then table.insert(sides.bottom, name(i,j) .. ".bottom") end
    if j == 3 then table.insert(sides.top, name(i,j) .. ".top") end
  end end
else
  joints = joints()
end
-- With an even pressure nothing acts at corners. Held edges have more supports than movements where joints end.
local supports = { a = Support { at = {0,0}, fix = "xy" }, b = Support { at = {2,0}, fix = "y" }, c = Support { at = {0,2}, fix = "x" } }
local pressures = {}
for _, side in pairs(sides) do for _, edge in ipairs(side) do pressures[edge] = q end end
if edges then
  supports = {}
  for _, edge in ipairs(sides.left) do supports[edge], pressures[edge] = "x", nil end
  for _, edge in ipairs(sides.bottom) do supports[edge], pressures[edge] = "y", nil end
end

return Scene {
  title = "Joints that meet", plane = "strain", geometry = geometry, joints = joints,
  mesh = cut == "wall" and mesh.structured { cells = {1,1} } or cut == "cell" and mesh.structured { cells = {7,7} } or mesh.voronoi { cells = 60, seed = 3 },
  element = "vem", order = order, supports = supports,
  stages = { Stage { "press", pressures = pressures } },
  outputs = { fields = { "displacement", "stress" } },
}
