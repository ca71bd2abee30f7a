-- expect: memory
local heap = string.rep("x", 2^32)
