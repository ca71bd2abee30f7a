-- expect 2: 'load' is not available to scripts
load("return 1")()
return Scene {}
