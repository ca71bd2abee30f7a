// ashlar study: many runs of one scene, and what accuracy costs.

#include <algorithm>
#include <iostream>
#include <sstream>
#include <system_error>
#include <thread>

#include "app/host.hpp"
#include "app/interrupt.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "core/log.hpp"
#include "model/scene_names.hpp"
#include "output/files.hpp"
#include "output/transaction.hpp"
#include "study/cases.hpp"
#include "study/page/page.hpp"
#include "study/runner.hpp"
#include "study/tables.hpp"

namespace ashlar::app {

namespace {

namespace fs = std::filesystem;

/// The study as the script says it, with what each of its cases finds in the scene.
struct Plan {
  core::Registry registry = make_registry();
  script::ScriptResult script;  ///< keeps the study's functions alive
  study::Study study;
  std::vector<study::Job> jobs;
};

/// A file's size and time: enough to see that it was built or written anew.
std::string stamp(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  const auto time = fs::last_write_time(file, error).time_since_epoch().count();
  return file.string() + ":" + std::to_string(error ? 0 : size) + ":" + std::to_string(time) + "\n";
}

std::string program_file() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).string();
}

/// The program and every library of ours: costs belong to them, so other ones make other runs.
std::string program_text(const core::Registry& registry) {
  const fs::path program = program_file();
  const char* library = "libashlar_framework.so";
  std::string text = "ashlar " ASHLAR_VERSION "\n" + stamp(program);
  std::error_code error;
  for (const fs::path& place : {program.parent_path(), program.parent_path() / "../" ASHLAR_LIBDIR})
    if (fs::exists(place / library, error)) text += stamp(fs::canonical(place / library, error));
  for (const core::Registry::Module& module : registry.modules())
    if (!module.library.empty()) text += stamp(module.library);
  return text;
}

std::string inputs_of(const Scenario& scenario, const std::string& settings, const std::string& program) {
  std::string text = program + settings;
  for (const auto& [path, source] : scenario.script.sources) text += path.string() + "\n" + source + "\n";
  model::visit_names(scenario.scene.root, scenario.registry, [&](const model::NameUse& use) {
    if (use.what == "file") text += stamp(fs::path(use.place.file).parent_path() / use.word);
  });
  return study::hash_text(text);
}

/// Mistakes of many cases, each told once, with a case that has it.
class Gathered {
 public:
  void add(const std::vector<core::Mistake>& mistakes, const study::Case& one) {
    for (const core::Mistake& mistake : mistakes) add(mistake, one);
  }
  void tell(std::size_t cases, core::Mistakes& mistakes) const {
    for (const Entry& entry : entries_) {
      std::string where = entry.own || entry.count == cases ? "" : ", in the case " + entry.label;
      if (!where.empty() && entry.count > 1) where += " and " + std::to_string(entry.count - 1) + " more";
      mistakes.add(entry.mistake.place, entry.mistake.what + where, entry.mistake.advice);
    }
  }

 private:
  struct Entry {
    std::string key;
    core::Mistake mistake;
    std::string label;
    bool own;  ///< of one of the study's own lines, which tells the case
    std::size_t count;
  };

  void add(core::Mistake mistake, const study::Case& one) {
    bool own = false;
    for (const study::Setting& setting : one.settings) {
      if (mistake.place.file != "--set " + setting.key) continue;
      mistake.place = setting.value.place;
      own = true;
    }
    std::string key = core::to_string(mistake.place) + mistake.what;
    // A parameter that is not there is missing at each of its values.
    const std::string missing = "the script has no parameter";
    if (own && mistake.what.starts_with(missing)) {
      mistake.what = "the scene has no parameter" + mistake.what.substr(missing.size());
      key = mistake.what;
    }
    for (Entry& entry : entries_)
      if (entry.key == key) {
        ++entry.count;
        return;
      }
    entries_.push_back({key, std::move(mistake), study::label(one), own, 1});
  }

  std::vector<Entry> entries_;
};

/// Reads and checks the scene of every case; nothing is computed.
void look_at_cases(const CommandLine& line, Plan& plan, core::Mistakes& mistakes) {
  const std::string program = program_text(plan.registry);
  const std::vector<std::string> names = study::folder_names(plan.study.cases);
  Gathered gathered;
  for (std::size_t c = 0; c < plan.study.cases.size(); ++c) {
    stop_if_interrupted();
    const study::Case& one = plan.study.cases[c];
    study::Job job{names[c], study::label(one), "", {}};
    CommandLine scene;
    scene.words = {plan.study.scene.string()};
    scene.trust = line.trust;
    std::string settings = std::to_string(plan.study.threads) + (plan.study.files ? " files\n" : "\n");
    for (const study::Setting& setting : one.settings) {
      scene.set.emplace_back(setting.key, study::set_text(setting.value));
      job.settings.push_back(setting.key + "=" + scene.set.back().second);
      settings += job.settings.back() + "\n";
    }
    try {
      const auto scenario = read_scenario(scene);
      core::Mistakes lacks;
      if (one.without.empty()) study::check_measures(plan.study, study::facts_of(scenario->scene), lacks);
      gathered.add(lacks.list(), one);
      job.inputs = inputs_of(*scenario, settings, program);
    } catch (const core::InputError& error) {
      gathered.add(error.mistakes(), one);
    }
    plan.jobs.push_back(std::move(job));
  }
  gathered.tell(plan.study.cases.size(), mistakes);
}

Plan read_plan(const CommandLine& line) {
  Plan plan;
  core::Mistakes mistakes;
  script::Options options;
  options.set = line.set;
  options.trust = line.trust;
  options.library = script_folders();
  options.returns = {"Study"};
  plan.script = script::read_scene(line.words.front(), plan.registry, options, mistakes);
  const core::Table* said = plan.script.scene.table();
  if (said && said->constructor == "Study")
    plan.study = study::read_study(plan.script.scene, plan.registry, mistakes);
  mistakes.throw_if_any();
  if (line.threads > 0) plan.study.threads = line.threads;
  look_at_cases(line, plan, mistakes);
  mistakes.throw_if_any();
  return plan;
}

double exact_value(const study::Measure& measure, const study::Case& one) {
  if (const core::Quantity* number = measure.reference.quantity()) return number->value;
  std::vector<std::pair<std::string, core::Value>> named;
  for (const study::Setting& setting : one.settings) named.emplace_back(setting.key, setting.value);
  return script::call_with(*measure.reference.function(), named, study::label(one)).value;
}

/// A reference that fails would cost all runs before it is seen.
void try_references(const study::Study& study) {
  core::Mistakes mistakes;
  for (const study::Measure& measure : study.measures)
    for (const study::Case& one : study.cases) {
      if (!measure.reference.function() || !one.without.empty()) continue;
      try {
        exact_value(measure, one);
      } catch (const core::InputError& error) {
        mistakes.add(error);
        break;
      }
    }
  mistakes.throw_if_any();
}

fs::path folder_of(const CommandLine& line) {
  if (!line.out.empty()) return line.out;
  const fs::path said = line.words.front();
  if (fs::is_directory(said)) return said / "results" / "study";
  return said.parent_path() / "results" / said.stem();
}

void forget_unwanted(const CommandLine& line, const Plan& plan, study::State& state) {
  for (const study::Job& job : plan.jobs) {
    const study::CaseRecord& record = state.record(job.name, job.inputs);
    const bool failed = !record.runs.empty() && record.runs.back().code != 0;
    if (line.resume == "none" || (line.resume == "good" && failed)) state.forget(job.name);
  }
}

/// True if all runs are there.
bool run_all(const CommandLine& line, const Plan& plan, study::State& state, Progress& progress) {
  study::RunnerOptions options;
  options.program = program_file();
  if (line.trust) options.words.emplace_back("--trust");
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.jobs = line.jobs > 0 ? line.jobs : std::max(1, cores / plan.study.threads);
  options.stopped = was_interrupted;
  options.say = [&](const std::string& text) {
    if (!was_interrupted()) progress.begin(text);
  };
  return study::run_jobs(plan.study, plan.jobs, options, state);
}

void tell(const study::Study& study, const std::vector<study::Outcome>& outcomes,
          const study::Analysis& analysis, const std::vector<fs::path>& files) {
  std::cout << study.title << '\n';
  for (const study::Finding& finding : analysis.findings)
    for (const std::string& sentence : finding.sentences) std::cout << "  " << sentence << '\n';
  for (std::size_t c = 0; c < outcomes.size(); ++c) {
    if (!outcomes[c].ok)
      std::cout << "  failed: " << study::label(study.cases[c]) << ": " << outcomes[c].reason << '\n';
    for (const std::string& missing : outcomes[c].missing)
      std::cout << "  " << study::label(study.cases[c]) << ": " << missing << '\n';
  }
  for (const fs::path& file : files) std::cout << "  " << file.string() << '\n';
}

std::vector<fs::path> write_study(const CommandLine& line, const study::Study& study,
                                  const std::vector<study::Outcome>& outcomes,
                                  const study::Analysis& analysis, const fs::path& folder) {
  output::Transaction transaction(folder);
  output::write_file(transaction.file("study.html"), study::study_page(study, outcomes, analysis, line.text));
  output::write_file(transaction.file("study.csv"), study::study_csv(study, outcomes, analysis));
  output::write_file(transaction.file("study.md"), study::study_markdown(study, outcomes));
  output::write_file(transaction.file("study.json"), study::study_json(study, outcomes, analysis));
  return transaction.commit();
}

}  // namespace

int study(const CommandLine& line) {
  // Warnings of a scene that is read for every case would come again and again; each run logs its own.
  core::log().set_sink({});
  const Plan plan = read_plan(line);
  try_references(plan.study);
  show_log(line.quiet);
  const fs::path folder = folder_of(line);
  study::State state(folder);
  forget_unwanted(line, plan, state);
  bool finished = false;
  {
    Progress progress(line.quiet);
    finished = run_all(line, plan, state, progress);
  }
  if (!finished) {
    std::cerr << "The runs that are done are kept: the same command goes on from there.\n";
    throw Interrupted();
  }
  std::vector<study::Outcome> outcomes;
  for (const study::Job& job : plan.jobs)
    outcomes.push_back(study::read_outcome(plan.study, folder, job.name, state.record(job.name, job.inputs)));
  // What lacks an effect may lack its measures.
  for (std::size_t c = 0; c < outcomes.size(); ++c)
    if (!plan.study.cases[c].without.empty()) outcomes[c].missing.clear();
  const study::Analysis analysis = study::analyse(plan.study, outcomes, exact_value);
  const auto files = write_study(line, plan.study, outcomes, analysis, folder);
  if (!line.quiet) tell(plan.study, outcomes, analysis, files);
  const bool any = std::ranges::any_of(outcomes, &study::Outcome::ok);
  if (any) return done;
  std::cerr << "Every run failed: " << outcomes.front().reason << '\n';
  return not_converged;
}

}  // namespace ashlar::app
