-- expect 2: 'os' is not available to scripts
os.execute("touch stolen")
return Scene {}
