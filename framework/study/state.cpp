#include "study/state.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>

#include "output/files.hpp"

namespace ashlar::study {

namespace {

using nlohmann::json;

constexpr int format = 1;
constexpr const char* state_name = "study.state";
constexpr const char* lock_name = ".study.lock";

CaseRecord read_record(const json& said) {
  CaseRecord record{said.at("inputs"), {}};
  for (const json& run : said.at("runs"))
    record.runs.push_back(
        {run.at("code"), run.at("reason"), run.at("wall"), run.at("cpu"), run.at("memory")});
  return record;
}

std::map<std::string, CaseRecord> read_records(const std::filesystem::path& path) {
  std::map<std::string, CaseRecord> records;
  std::ifstream file(path);
  const json said = json::parse(file, nullptr, false);
  try {
    if (!said.is_object() || said.at("format") != format) return {};
    for (const auto& [name, record] : said.at("cases").items()) records[name] = read_record(record);
  } catch (const json::exception&) {
    return {};
  }
  return records;
}

}  // namespace

State::State(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) output::fail_to_write(folder_, error.value());
  lock_ = ::open((folder_ / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) output::fail_to_write(folder_ / lock_name, errno);
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    core::Mistakes mistakes;
    mistakes.add({folder_.string(), 0, {}}, "another study is at work in this folder",
                 "wait for it, or name another folder with --out");
    mistakes.throw_if_any();
  }
  records_ = read_records(folder_ / state_name);
}

State::~State() {
  ::close(lock_);
}

CaseRecord& State::record(const std::string& name, const std::string& inputs) {
  CaseRecord& record = records_[name];
  if (record.inputs != inputs) record = {inputs, {}};
  return record;
}

void State::save() const {
  json cases = json::object();
  for (const auto& [name, record] : records_) {
    json runs = json::array();
    for (const RunRecord& run : record.runs)
      runs.push_back({{"code", run.code},
                      {"reason", run.reason},
                      {"wall", run.wall},
                      {"cpu", run.cpu},
                      {"memory", run.memory}});
    cases[name] = {{"inputs", record.inputs}, {"runs", runs}};
  }
  const json all = {{"format", format}, {"cases", cases}};
  const std::filesystem::path partial = folder_ / (std::string(state_name) + ".partial");
  output::write_file(partial, all.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
  std::filesystem::rename(partial, folder_ / state_name);
}

}  // namespace ashlar::study
