-- expect 3: stack overflow
local function dig(n)
  return dig(n + 1) + 1
end
return dig(1)
