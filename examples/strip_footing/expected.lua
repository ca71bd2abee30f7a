local prandtl = 0.5 * (2 + math.pi) * 10e3
return {
  { numbers = {
      { at = "stages.push.balance.reactions.footing.y", value = -prandtl, tolerance = 0.025*prandtl,
        why = "Prandtl's limit load; elements of this size find 2.3 % more" },
      { at = "stages.push.balance.relative_error", value = 0, tolerance = 1e-10, why = "round-off" },
    } },
  { set = { fine = 0.03 },
    numbers = {
      { at = "stages.push.balance.reactions.footing.y", value = -prandtl, tolerance = 0.02*prandtl,
        why = "Prandtl's limit load; elements of this size find 1.5 % more" } } },
}
