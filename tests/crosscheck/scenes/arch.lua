-- A semicircular arch of wedges on two abutments, standing by pressure and friction alone.
local u = units
local wedges = param { "wedges", default = 11 }
local thickness = param { "thickness", default = 0.18, doc = "over the mean radius of 5 m" }
local angle = param { "friction_angle", default = 35.0, doc = "in degrees" }
local stone = material.elastic { E = 20*u.GPa, nu = 0.2, unit_weight = 25*u.kN/u.m^3 }
local R = 5.0
local inner, outer = R*(1 - thickness/2), R*(1 + thickness/2)
local function at(r, i, name) local a = math.pi*i/wedges return { r*math.cos(a), r*math.sin(a), name } end
local geometry, joints = {}, {}
local function friction() return contact.coulomb { friction_angle = angle*u.deg } end
for i = 1, wedges do
  geometry["w" .. i] = Polygon { at(inner, i-1), at(outer, i-1), at(outer, i), at(inner, i), material = stone }
  if i > 1 then joints["j" .. (i-1)] = Joint { between = { "w" .. i, "w" .. (i-1) }, friction = friction(), enforce = "lagrange" } end
end
geometry.right = Polygon { {inner,-0.5,"bottom"}, {outer,-0.5}, {outer,0}, {inner,0}, material = stone }
geometry.left = Polygon { {-outer,-0.5,"bottom"}, {-inner,-0.5}, {-inner,0}, {-outer,0}, material = stone }
joints.foot_right = Joint { between = { "w1", "right" }, friction = friction(), enforce = "lagrange" }
joints.foot_left = Joint { between = { "w" .. wedges, "left" }, friction = friction(), enforce = "lagrange" }
return Scene {
  title = "A wedge arch", plane = "strain", geometry = geometry, joints = joints,
  mesh = mesh.voronoi { size = 0.15, seed = 4 }, element = "vem", order = 1,
  supports = { ["right.bottom"] = "xy", ["left.bottom"] = "xy" },
  stages = { Stage { "weight", gravity = true } },
}
