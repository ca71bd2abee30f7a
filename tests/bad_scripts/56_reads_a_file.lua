-- expect 2: 'io' is not available to scripts
local f = io.open("/etc/hostname")
return Scene {}
