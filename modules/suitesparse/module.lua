-- Direct solution of the linear systems with SuiteSparse's CHOLMOD (supernodal part: GPL) and UMFPACK (GPL).
return {
  name = "suitesparse",
  doc = "Sparse Cholesky factorisation by CHOLMOD, with METIS or AMD ordering; sparse LU by UMFPACK.",
  provides = {
    { kind = "solver", name = "suitesparse", constructor = "solver.suitesparse",
      doc = "Supernodal Cholesky factorisation; the same bits on every number of threads.",
      parameters = {
        { key = "ordering", forms = { "text" }, choices = { "auto", "metis", "amd" }, default = "auto",
          numerical = true, doc = "Order of elimination; auto takes METIS for large systems and AMD below." },
      } },
    { kind = "unsymmetric_solver", name = "umfpack",
      doc = "Multifrontal LU factorisation, for tangents that are not symmetric; taken where a law calls for it.",
      parameters = {} },
  },
}
