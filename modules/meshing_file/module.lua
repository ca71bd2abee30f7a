return {
  name = "meshing_file",
  doc = "Meshes made by other programs: gmsh .msh, VTK .vtk and .vtu.",
  provides = {
    { kind = "mesh", name = "file", constructor = "mesh.file",
      doc = "Reads linear cells; physical groups become regions, borders and point groups. "
         .. "Borders keep their bare names: [\"foot\"], not [\"rock.foot\"].",
      parameters = {
        { key = "path", forms = { "text" }, required = true, refers = "file",
          doc = "the file; a relative path starts at the scene's folder" },
      } },
  },
}
