-- expect 3: the script must return Study { … }, but returns Scene { … }
-- expect: it is a scene: `ashlar run
return Scene { title = "x" }
