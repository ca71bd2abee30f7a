#pragma once
// Files appear in the results folder whole or not at all, and a failed run leaves earlier results alone.
// A run writes into a hidden folder beside the results ("results" → ".results.partial-4711"); commit moves
// the finished files over.

#include <filesystem>
#include <string>
#include <vector>

namespace ashlar::output {

class Transaction {
 public:
  /// Makes the results folder if there is none, and the staging folder beside it; removes what killed runs
  /// left behind. Throws InputError with the path and the system's reason if it cannot.
  explicit Transaction(std::filesystem::path folder);
  /// Removes the staging folder.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// Where to write the file `name` ("mesh.png", "vtk/01_full.vtu"); it will become folder/name.
  std::filesystem::path file(const std::string& name);
  /// Moves all files into the results folder, then removes files of earlier runs that this one did not make.
  /// Returns the files' places in the order in which they were asked for.
  std::vector<std::filesystem::path> commit();

 private:
  void make_staging();
  void remove_leftovers() const;
  void move_files() const;
  void write_manifest(const std::vector<std::string>& names) const;

  std::filesystem::path folder_, staging_;
  std::vector<std::string> names_;
  int lock_ = -1;             ///< held as long as this run lives
  bool made_folder_ = false;  ///< an empty folder of a failed run goes again
};

/// The files that earlier runs made in `folder`, as its manifest tells; unsafe names are left out.
std::vector<std::string> manifest(const std::filesystem::path& folder);

/// Removes the files that earlier runs made in `folder`, and the folder if nothing else is in it.
void remove_results(const std::filesystem::path& folder);

}  // namespace ashlar::output
