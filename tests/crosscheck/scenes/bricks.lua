-- A wall of bricks in running bond, its weight on it; each course is pushed by `push` times its own weight.
local u = units
local rows, columns, cells = 6, 4, 2   -- cells over a course
local push = param { "push", default = 0.2 }
local mu = param { "mu", default = 0.6 }
local enforce = param { "enforce", default = "lagrange" }
local pairing = param { "pairing", default = "node_to_segment" }
local brick = material.elastic { E = 10*u.GPa, nu = 0.2, unit_weight = 20*u.kN/u.m^3 }
local a, b = 0.4, 0.2
local geometry, joints, supports = {}, {}, {}
local function joint(x, y, n)
  joints["j" .. n] = Joint { between = { x, y }, friction = contact.coulomb { friction_angle = math.atan(mu) }, enforce = enforce, pairing = pairing }
end
local names, count = {}, 0
geometry.ground = Rectangle { from = {-0.4,-0.2}, to = {columns*a + 0.4,0}, material = brick }
supports["ground.bottom"] = "xy"
for r = 1, rows do
  names[r] = {}
  local x, i = 0, 0
  while x < columns*a - 1e-9 do
    i = i + 1
    local w = (r % 2 == 0 and (i == 1)) and a/2 or a
    if x + w > columns*a then w = columns*a - x end
    local name = "b" .. r .. "_" .. i
    geometry[name] = Rectangle { from = {x,(r-1)*b}, to = {x+w,r*b}, material = brick }
    names[r][i] = { name = name, from = x, to = x + w }
    if i > 1 then count = count + 1; joint(names[r][i-1].name, name, count) end
    local below = r == 1 and { { name = "ground", from = -1, to = 100 } } or names[r-1]
    for _, under in ipairs(below) do
      if under.from < x + w - 1e-9 and under.to > x + 1e-9 then count = count + 1; joint(name, under.name, count) end
    end
    x = x + w
  end
end
local pushes = {}
for r = 1, rows do pushes[names[r][1].name .. ".left"] = { x = push*20*u.kN/u.m^3*columns*a*u.m } end
return Scene {
  title = "Brick wall", plane = "strain", geometry = geometry, joints = joints,
  mesh = mesh.structured { size = b/cells }, element = "vem", supports = supports,
  stages = { Stage { "weight", gravity = true }, Stage { "push", gravity = true, tractions = pushes } },
  outputs = { fields = { "displacement", "stress" } },
}
