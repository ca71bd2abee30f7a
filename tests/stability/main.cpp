// The page of hard cases:  stability [--planted] [--only WORD] [FOLDER]
// Writes stability.txt and stability.html into the folder, and fails if a row is red that should not be. With
// --planted every row is run once more under each of its faults, and fails if it does not turn red.

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "stability/table.hpp"

namespace ashlar::stability {
namespace {

struct Request {
  bool planted = false;
  std::string only;
  std::filesystem::path folder = ".";
};

std::vector<Case> all_rows(const std::string& only) {
  std::vector<Case> all;
  for (const auto& rows : {mesh_rows(), law_rows(), copy_rows(), solve_rows(), load_rows(), support_rows(),
                           contact_rows(), crossing_rows(), friction_rows(), cycle_rows(), sliding_rows()})
    for (const Case& row : rows)
      if (row.name.find(only) != std::string::npos || row.group.find(only) != std::string::npos)
        all.push_back(row);
  return all;
}

int make_page(const Request& request) {
  const std::vector<Case> rows = all_rows(request.only);
  std::vector<Result> results;
  std::vector<Planted> planted;
  int wrong = 0;
  for (const Case& row : rows) {
    const auto start = std::chrono::steady_clock::now();
    Result result{&row, run(row, Fault::none), 0};
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (verdict(result) == "RED") ++wrong;
    results.push_back(std::move(result));
    if (!request.planted) continue;
    for (const Fault fault : row.plants) {
      const Outcome outcome = run(row, fault);
      planted.push_back({&row, fault, !outcome.green(), measured_text(outcome)});
      if (outcome.green()) ++wrong;
    }
  }
  const std::string text = text_page(results, planted);
  std::fputs(text.c_str(), stdout);
  std::filesystem::create_directories(request.folder);
  std::ofstream(request.folder / "stability.txt") << text;
  std::ofstream(request.folder / "stability.html") << html_page(results, planted);
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ashlar::stability

int main(int count, char** words) {
  ashlar::stability::Request request;
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(words[i], "--planted") == 0)
      request.planted = true;
    else if (std::strcmp(words[i], "--only") == 0 && i + 1 < count)
      request.only = words[++i];
    else
      request.folder = words[i];
  }
  return ashlar::stability::make_page(request);
}
