// What we write for ParaView, read by VTK itself.
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <regex>

#include "output/files.hpp"
#include "output/vtk.hpp"
#include "output/write_all.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

vtkUnstructuredGrid* read(vtkXMLUnstructuredGridReader* reader, const std::filesystem::path& file) {
  EXPECT_TRUE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST(vtk, cells_come_back_as_the_same_polygons_and_values) {
  const Sample sample = make_sample(2);
  const mesh::Mesh& mesh = sample.model.mesh;
  const auto out = fresh_folder("vtk");
  write_results(sample.record(), out);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkUnstructuredGrid* grid = read(reader, out / "vtu" / "02_reservoir.vtu");
  ASSERT_EQ(grid->GetNumberOfPoints(), mesh.point_count());
  ASSERT_EQ(grid->GetNumberOfCells(), mesh.cell_count());
  for (mesh::Index p = 0; p < mesh.point_count(); ++p) {
    EXPECT_EQ(grid->GetPoint(p)[0], mesh.points[p].x);
    EXPECT_EQ(grid->GetPoint(p)[1], mesh.points[p].y);
  }
  for (mesh::Index c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_EQ(grid->GetCellType(c), VTK_POLYGON);
    vtkIdList* ids = grid->GetCell(c)->GetPointIds();
    const auto ring = mesh.cell_points[c];
    ASSERT_EQ(ids->GetNumberOfIds(), static_cast<vtkIdType>(ring.size()));
    for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_EQ(ids->GetId(static_cast<vtkIdType>(i)), ring[i]);
  }
  const auto& stage = sample.result.stages[1];
  vtkDataArray* u = grid->GetPointData()->GetArray("displacement");
  ASSERT_TRUE(u);
  ASSERT_EQ(u->GetNumberOfComponents(), 3);
  for (mesh::Index p = 0; p < mesh.point_count(); ++p) {
    EXPECT_EQ(u->GetComponent(p, 0), stage.fields[0].values[2 * p]);
    EXPECT_EQ(u->GetComponent(p, 1), stage.fields[0].values[2 * p + 1]);
    EXPECT_EQ(u->GetComponent(p, 2), 0);
  }
  vtkDataArray* stress = grid->GetCellData()->GetArray("stress");
  ASSERT_TRUE(stress);
  ASSERT_EQ(stress->GetNumberOfComponents(), 4);
  EXPECT_STREQ(stress->GetComponentName(2), "xy");
  for (mesh::Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < 4; ++k) EXPECT_EQ(stress->GetComponent(c, k), stage.fields[1].values[4 * c + k]);
  vtkDataArray* region = grid->GetCellData()->GetArray("region");
  ASSERT_TRUE(region);
  for (mesh::Index c = 0; c < mesh.cell_count(); ++c) EXPECT_EQ(region->GetTuple1(c), mesh.cell_region[c]);
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("region_names"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(1), "dam");
}

TEST(vtk, joints_come_back_as_lines_that_stop_between_pieces) {
  const Sample sample = make_sample(2);
  const auto file = fresh_folder("vtk-joints") / "joints.vtu";
  const auto& joint = sample.result.stages[1].joints[0];
  write_file(file, joints_vtu(sample.result.stages[1]));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  vtkUnstructuredGrid* grid = read(reader, file);
  const auto rows = static_cast<vtkIdType>(joint.rows.size());
  ASSERT_EQ(grid->GetNumberOfPoints(), rows);
  ASSERT_EQ(grid->GetNumberOfCells(), rows - 2);
  for (vtkIdType c = 0; c < rows - 2; ++c) {
    EXPECT_EQ(grid->GetCellType(c), VTK_LINE);
    vtkIdList* ids = grid->GetCell(c)->GetPointIds();
    EXPECT_EQ(joint.rows[ids->GetId(0)].piece, joint.rows[ids->GetId(1)].piece);
  }
  for (vtkIdType i = 0; i < rows; ++i) {
    EXPECT_EQ(grid->GetPointData()->GetArray("opening")->GetTuple1(i), joint.rows[i].opening);
    EXPECT_EQ(grid->GetPointData()->GetArray("slip")->GetTuple1(i), joint.rows[i].slip);
    EXPECT_EQ(grid->GetPointData()->GetArray("pressure")->GetTuple1(i), joint.rows[i].pressure);
    EXPECT_EQ(grid->GetPointData()->GetArray("closed")->GetTuple1(i), joint.rows[i].closed ? 1 : 0);
  }
}

TEST(vtk, every_file_of_the_collection_is_there) {
  const auto out = fresh_folder("pvd");
  write_results(make_sample(1).record(), out);
  const std::string text = slurp(out / "results.pvd");
  const std::regex file("file=\"([^\"]+)\"");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), file), end; it != end; ++it, ++count) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    EXPECT_GT(read(reader, out / (*it)[1].str())->GetNumberOfCells(), 0) << (*it)[1];
  }
  EXPECT_EQ(count, 4);
}

}  // namespace
}  // namespace ashlar::output
