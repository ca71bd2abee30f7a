-- expect 3: the script did not end within 10 s
local n = 0
while true do n = n + 1 end
