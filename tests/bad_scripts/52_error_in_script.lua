-- expect 3: the crest is below the base
local function height(h)
  if h < 0 then error("the crest is below the base") end
  return h
end
return height(-3)
