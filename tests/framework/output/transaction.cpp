#include "output/transaction.hpp"

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>
#include <fstream>

#include "core/error.hpp"
#include "output/files.hpp"
#include "sample.hpp"

namespace ashlar::output {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void run(const fs::path& folder, const std::vector<std::string>& names, const std::string& text) {
  Transaction transaction(folder);
  for (const std::string& name : names) write_file(transaction.file(name), text);
  transaction.commit();
}

TEST(transaction, files_appear_on_commit_only) {
  const fs::path root = fresh_folder("commit"), folder = root / "results";
  {
    Transaction transaction(folder);
    write_file(transaction.file("a.txt"), "1");
    write_file(transaction.file("vtu/b.txt"), "2");
    EXPECT_TRUE(fs::is_empty(folder));
    const auto files = transaction.commit();
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(slurp(files[0]), "1");
    EXPECT_EQ(slurp(folder / "vtu/b.txt"), "2");
  }
  EXPECT_EQ(names_in(root), std::vector<std::string>{"results"});
}

TEST(transaction, a_failed_run_leaves_earlier_results_alone) {
  const fs::path root = fresh_folder("failed"), folder = root / "results";
  run(folder, {"a.txt"}, "old");
  EXPECT_THROW(
      {
        Transaction transaction(folder);
        write_file(transaction.file("a.txt"), "new");
        throw std::runtime_error("the run fails");
      },
      std::runtime_error);
  EXPECT_EQ(slurp(folder / "a.txt"), "old");
  EXPECT_EQ(names_in(root), std::vector<std::string>{"results"});
}

TEST(transaction, a_failed_first_run_leaves_no_folder) {
  const fs::path root = fresh_folder("first");
  { Transaction transaction(root / "results"); }
  EXPECT_TRUE(fs::is_empty(root));
}

TEST(transaction, our_stale_files_go_and_others_stay) {
  const fs::path folder = fresh_folder("stale") / "results";
  run(folder, {"a.txt", "vtu/old.txt"}, "old");
  write_file(folder / "notes.txt", "mine");
  run(folder, {"a.txt"}, "new");
  EXPECT_EQ(slurp(folder / "a.txt"), "new");
  EXPECT_FALSE(fs::exists(folder / "vtu"));
  EXPECT_EQ(slurp(folder / "notes.txt"), "mine");
  remove_results(folder);
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"notes.txt"});
}

TEST(transaction, a_forged_manifest_reaches_nothing_outside) {
  const fs::path root = fresh_folder("forged"), folder = root / "results";
  write_file(root / "precious.txt", "keep");
  fs::create_directories(folder);
  write_file(folder / ".ashlar-files", "../precious.txt\n" + (root / "precious.txt").string() + "\n");
  run(folder, {"a.txt"}, "1");
  EXPECT_EQ(slurp(root / "precious.txt"), "keep");
}

TEST(transaction, leftovers_of_killed_runs_go_those_of_living_runs_stay) {
  const fs::path root = fresh_folder("leftovers"), folder = root / "results";
  // No process has numbers this large: only the lock tells the living (in a container, say) from the dead.
  const fs::path killed = root / ".results.partial-999999999", living = root / ".results.partial-999999998";
  for (const fs::path& path : {killed, living}) {
    fs::create_directories(path);
    write_file(path / ".lock", "");
    write_file(path / "half.txt", "ha");
  }
  const int lock = ::open((living / ".lock").c_str(), O_RDWR);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  run(folder, {"a.txt"}, "1");
  EXPECT_FALSE(fs::exists(killed));
  EXPECT_TRUE(fs::exists(living / "half.txt"));
  ::close(lock);
}

TEST(transaction, a_folder_that_cannot_be_made_is_the_users_mistake) {
  const fs::path root = fresh_folder("no-folder");
  write_file(root / "file", "");
  try {
    Transaction transaction(root / "file" / "results");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("results: cannot be written: Not a directory"),
              std::string::npos)
        << error.what();
  }
}

TEST(transaction, a_full_disk_is_told_by_path_and_reason) {
  try {
    write_file("/dev/full", "text");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/full: cannot be written: No space left on device"),
              std::string::npos)
        << error.what();
  }
}

// A limit on file sizes stands for a quota: the signal must not end the program, the old results must stay.
TEST(transaction, a_limit_on_file_size_leaves_earlier_results_alone) {
  const fs::path folder = fresh_folder("limit") / "results";
  run(folder, {"a.txt"}, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int code = 1;
    try {
      run(folder, {"a.txt"}, std::string(5000, 'x'));
    } catch (const core::InputError& error) {
      code = std::string(error.what()).find("File too large") != std::string::npos ? 7 : 2;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(slurp(folder / "a.txt"), "old");
}

TEST(files, names_are_made_safe) {
  EXPECT_EQ(file_name("self-weight"), "self-weight");
  EXPECT_EQ(file_name("../a b/ü"), "_.._a_b_ü");
  EXPECT_EQ(file_name(""), "_");
  EXPECT_EQ(stage_file_name(3, "full head"), "03_full_head");
}

TEST(files, numbers_read_back) {
  for (const double x : {0.1, 1.0 / 3, 1e-300, -5e22, 123456789.123456789})
    EXPECT_EQ(std::stod(shortest(x)), x);
  EXPECT_EQ(shortest(0.1), "0.1");
}

}  // namespace
}  // namespace ashlar::output
