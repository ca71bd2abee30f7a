-- Direct solution of the linear systems with SuiteSparse's CHOLMOD (supernodal part: GPL).
return {
  name = "suitesparse",
  doc = "Sparse Cholesky factorisation by CHOLMOD, with METIS or AMD ordering.",
  provides = {
    { kind = "solver", name = "suitesparse", constructor = "solver.suitesparse",
      doc = "Supernodal Cholesky factorisation; the same bits on every number of threads.",
      parameters = {
        { key = "ordering", forms = { "text" }, choices = { "auto", "metis", "amd" }, default = "auto",
          numerical = true, doc = "Order of elimination; auto takes METIS for large systems and AMD below." },
      } },
  },
}
