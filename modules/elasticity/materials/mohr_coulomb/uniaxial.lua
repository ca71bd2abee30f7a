-- Uniaxial compression until the rock yields, unloading, and tension up to the cut-off:
-- `ashlar drive` on this file. The strength is 2 c cos(phi)/(1 - sin(phi)) = 3.464 MPa.
local u = units
return Drive {
  title = "Uniaxial compression, unloading, tension",
  material = material.mohr_coulomb {
    E = 10*u.GPa, nu = 0.2, cohesion = 1*u.MPa, friction = 30*u.deg, dilation = 10*u.deg, tensile_strength = 0.5*u.MPa,
  },
  plane = "strain",
  steps = 40,
  path = {   -- yy is led, the stresses across it are held at zero
    { yy = -6e-4, sxx = 0, szz = 0 },
    { yy =  1e-4, sxx = 0, szz = 0 },
  },
}
