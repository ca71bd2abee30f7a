-- Direct shear of a rock joint at 1 MPa, and back: `ashlar drive` on this file. The peak is
-- c + p tan(phi) = 0.9 MPa, the residual strength p tan(30 degrees) = 0.5774 MPa, and slip wedges the lips open.
local u = units
return Drive {
  title = "Direct shear, back again, and lifted off",
  joint = {
    normal_law = contact.linear { stiffness = 20*u.GPa/u.m },
    friction = contact.coulomb {
      friction_angle = 35*u.deg, cohesion = 0.2*u.MPa,
      residual_friction_angle = 30*u.deg, residual_cohesion = 0, softening_slip = 4*u.mm,
      dilation_angle = 5*u.deg, dilation_slip = 10*u.mm, stiffness = 2*u.GPa/u.m,
    },
  },
  steps = 40,
  path = {   -- a leg names what it leads; the other direction keeps what led it last
    { pressure = 1*u.MPa },
    { slip = 10*u.mm },
    { slip = 0 },
    { opening = 2*u.mm },
  },
}
