// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/program.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "conformance/report/report.h"
#include "conformance/runner/baseline.h"
#include "conformance/runner/exit_status.h"
#include "conformance/runner/run.h"
#include "conformance/runner/selection.h"
#include "conformance/runner/worker.h"
#include "conformance/submission/submission.h"
#include "conformance/suite/case.h"

namespace glark::conformance {
namespace {

struct Options {
  RunOptions run;
  std::string api = "gl-compat";
  std::vector<std::string> globs;
  std::string case_list;
  std::string shard = "1/1";
  std::vector<std::string> baselines;
  std::string shown;
  bool is_list = false;
  bool is_json = false;
  bool is_must_pass = false;
  bool fails_fast = false;
};

// An error with its exit status.
struct Complaint {
  int status;
  std::string text;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("--platform", options.run.platform, "source of contexts")
      ->check(CLI::IsMember({"osmesa", "egl", "glx"}))
      ->capture_default_str();
  app.add_option("--api", options.api, "which API")
      ->check(CLI::IsMember({"gl-compat", "gl-core", "gles"}))
      ->capture_default_str();
  app.add_option("--implementation", options.run.implementation, "a library to preload into the processes of cases")
      ->check(CLI::ExistingFile);
  app.add_option("--case", options.globs, "run cases whose names match; may be repeated")
      ->allow_extra_args(false)
      ->type_name("GLOB");
  app.add_option("--caselist", options.case_list, "run cases that this file names, one a line")->type_name("FILE");
  app.add_flag("--must-pass", options.is_must_pass, "run the cases that an implementation has to pass");
  app.add_option("--shard", options.shard, "run part I of N of the selection")->type_name("I/N")->capture_default_str();
  app.add_flag("--list", options.is_list, "print the names of the selected cases");
  app.add_option("--show", options.shown, "run this case, and print its calls of OpenGL as a function in C")
      ->type_name("NAME");
  app.add_flag("--json", options.is_json, "with --list: also print clauses and plans");
  app.add_option("--report", options.run.report, "directory for results.json, junit.xml, log.txt and index.html")
      ->type_name("DIR");
  app.add_flag("--commands", options.run.notes_commands,
               "with --report: also note which commands of OpenGL each case calls");
  app.add_option("--baseline", options.baselines, "known failures; may be repeated")
      ->allow_extra_args(false)
      ->type_name("FILE");
  app.add_option("--jobs", options.run.jobs, "number of parallel processes")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--timeout", options.run.seconds, "time limit of a case, in seconds that it computes")
      ->check(CLI::Range(1, 86400))
      ->capture_default_str();
  app.add_option("--batch", options.run.cases_in_process, "number of cases in one process")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--retry", options.run.retries,
                 "run a failing case again, up to this many times; it is a flake if it passes then")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_flag("--fail-fast", options.fails_fast, "begin no case after a failure, and leave out the rest");
  app.add_option("--seed", options.run.seed, "seed of random values")->capture_default_str();
  app.add_flag("--verbose", options.run.is_verbose, "print every case, not only those that did not pass");
}

WorkerTask task_of(const std::string& name) {
  return name == "describe" ? WorkerTask::describe : name == "show" ? WorkerTask::show : WorkerTask::run;
}

Api api_of(const std::string& name) {
  return name == "gl-core" ? Api::gl_core : name == "gles" ? Api::gles : Api::gl_compat;
}

void read_shard(const std::string& text, Selection& selection) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d/%d%c", &selection.shard, &selection.shards, &rest) != 2 || selection.shards < 1 ||
      selection.shard < 1 || selection.shard > selection.shards)
    throw Complaint{exit_status::usage, "--shard " + text + ": expected I/N with 1 <= I <= N"};
}

std::vector<std::string> listed_names(const std::string& path) {
  try {
    return read_list(path);
  } catch (const std::runtime_error& error) {
    throw Complaint{exit_status::usage, error.what()};
  }
}

std::vector<std::string> selected_names(const Options& options) {
  Selection selection;
  selection.globs = options.globs;
  read_shard(options.shard, selection);
  if (options.is_must_pass) {
    selection.has_list = true;
    for (const RequiredCase& required : must_pass()) selection.names.push_back(required.name);
  }
  if (!options.case_list.empty()) {
    selection.has_list = true;
    const auto names = listed_names(options.case_list);
    selection.names.insert(selection.names.end(), names.begin(), names.end());
    if (names.empty()) throw Complaint{exit_status::no_case, options.case_list + " names no case"};
  }
  std::vector<std::string> all;
  for (const Case& each : all_cases()) all.push_back(each.name);
  try {
    auto names = select(all, selection);
    if (names.empty()) throw Complaint{exit_status::no_case, "no case is selected"};
    return names;
  } catch (const std::invalid_argument& error) {
    throw Complaint{exit_status::no_case, error.what()};
  }
}

std::vector<std::string_view> apis_of(const Case& each) {
  std::vector<std::string_view> names;
  for (const Api api : {Api::gl_compat, Api::gl_core, Api::gles})
    if (each.apis.contains(api)) names.push_back(name_of(api));
  return names;
}

int list(const std::vector<std::string>& names, bool is_json) {
  if (!is_json) {
    for (const std::string& name : names) std::printf("%s\n", name.c_str());
    return exit_status::passed;
  }
  nlohmann::json cases = nlohmann::json::array();
  for (const Case& each : all_cases())
    if (std::find(names.begin(), names.end(), each.name) != names.end())
      cases.push_back({{"name", each.name},
                       {"clauses", each.clauses},
                       {"plan", each.plan},
                       {"apis", apis_of(each)},
                       {"optional", each.is_optional},
                       {"commands", each.commands},
                       {"written", static_cast<bool>(each.check)}});
  std::printf("%s\n", nlohmann::json{{"cases", cases}}.dump(1).c_str());
  return exit_status::passed;
}

void say(const Record& record, std::size_t done, std::size_t all, bool is_verbose) {
  if (!is_verbose && (record.verdict == Verdict::pass || record.verdict == Verdict::not_supported)) return;
  std::printf("[%zu/%zu] %s %s\n", done, all, std::string(name_of(record.verdict)).c_str(), record.name.c_str());
  if (record.verdict != Verdict::pass)
    for (const std::string& message : record.messages) std::printf("    %s\n", message.c_str());
  std::fflush(stdout);
}

int exit_status_of(const std::vector<Record>& records, const Environment& environment) {
  for (const Record& record : records)
    if (is_bad(record.verdict)) return exit_status::failed;
  return environment.at("GL_ARK_adaptive_refinement") == "yes" ? exit_status::passed : exit_status::not_supported;
}

std::vector<Expectation> read_baselines(const std::vector<std::string>& paths) {
  std::vector<Expectation> all;
  try {
    for (const std::string& path : paths) {
      const auto more = read_baseline(path);
      all.insert(all.end(), more.begin(), more.end());
    }
  } catch (const std::runtime_error& error) {
    throw Complaint{exit_status::usage, error.what()};
  }
  return all;
}

// Makes the report's directory, and paths that other processes can use.
void prepare(RunOptions& options) {
  try {
    if (!options.report.empty()) {
      prepare_report(options.report);
      options.report = std::filesystem::absolute(options.report);
    }
  } catch (const std::runtime_error& error) {
    throw Complaint{exit_status::no_report, error.what()};
  }
  // Without a slash, the dynamic linker would search elsewhere.
  if (!options.implementation.empty()) options.implementation = std::filesystem::absolute(options.implementation);
}

// What another process answers.
template <typename Answer>
Answer answer_of(const std::function<Answer()>& ask) {
  try {
    return ask();
  } catch (const std::invalid_argument& error) {
    throw Complaint{exit_status::usage, error.what()};
  } catch (const std::runtime_error& error) {
    throw Complaint{exit_status::no_context, error.what()};
  }
}

int print_calls(const std::string& name, RunOptions& options) {
  prepare(options);
  const auto& cases = all_cases();
  if (std::none_of(cases.begin(), cases.end(), [&](const Case& each) { return each.name == name; }))
    throw Complaint{exit_status::no_case, "no case " + name};
  const auto text = answer_of<std::string>([&] { return show_case(name, options); });
  std::fwrite(text.data(), 1, text.size(), stdout);
  return exit_status::passed;
}

Environment environment_of(const RunOptions& options) {
  Environment environment = answer_of<Environment>([&] { return describe_environment(options); });
  environment["platform"] = options.platform;
  environment["must-pass list"] = std::to_string(must_pass_version);
  environment["seed"] = std::to_string(options.seed);
  return environment;
}

std::vector<Record> run_cases(const std::vector<std::string>& names, const Options& options,
                              const std::vector<Expectation>& baseline) {
  std::size_t done = 0;
  std::vector<Record> records = run(names, options.run, [&](const Record& record) {
    ++done;
    std::vector<Record> one = {record};
    apply_baseline(baseline, one);
    say(one.front(), done, names.size(), options.run.is_verbose);
    return !(options.fails_fast && is_bad(one.front().verdict));
  });
  apply_baseline(baseline, records);
  return records;
}

int judge(Options& options, const std::vector<std::string>& command) {
  options.run.api = api_of(options.api);
  if (!options.shown.empty()) return print_calls(options.shown, options.run);
  const auto names = selected_names(options);
  if (options.is_list) return list(names, options.is_json);

  const std::vector<Expectation> baseline = read_baselines(options.baselines);
  prepare(options.run);
  Report report;
  report.environment = environment_of(options.run);
  report.command = command;
  const auto begin = std::chrono::steady_clock::now();
  report.records = run_cases(names, options, baseline);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (report.environment["GL_ARK_adaptive_refinement"] != "yes")
    std::fprintf(stderr, "glark-conformance: %s has no GL_ARK_adaptive_refinement; nothing could be judged\n",
                 report.environment["renderer"].c_str());
  try {
    if (!options.run.report.empty()) write_report(report, options.run.report);
  } catch (const std::exception& error) {
    throw Complaint{exit_status::no_report, error.what()};
  }
  std::printf("%s in %.1f s\n", summary_of(report.records).c_str(), report.seconds);
  return exit_status_of(report.records, report.environment);
}

int make_package(const std::string& directory, const std::string& archive) {
  try {
    package(directory, archive);
  } catch (const std::exception& error) {
    throw Complaint{exit_status::usage, error.what()};
  }
  std::printf("%s\n", archive.c_str());
  return exit_status::passed;
}

int check_package(const std::string& archive) {
  std::vector<std::string> complaints;
  try {
    complaints = verify(archive);
  } catch (const std::exception& error) {
    throw Complaint{exit_status::failed, error.what()};
  }
  for (const std::string& complaint : complaints) std::printf("%s\n", complaint.c_str());
  std::printf(complaints.empty() ? "stands\n" : "does not stand\n");
  return complaints.empty() ? exit_status::passed : exit_status::failed;
}

int try_program(int argc, char** argv) {
  Options options;
  options.run.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  CLI::App app("Judges the implementation of GL_ARK_adaptive_refinement that the dynamic linker finds.",
               "glark-conformance");
  describe(app, options);
  std::string directory;
  std::string archive;
  std::string task;
  std::vector<std::string> names;
  CLI::App* const packaging = app.add_subcommand("package", "puts a report into an archive, for someone else to check");
  packaging->add_option("DIR", directory, "of --report")->required();
  packaging->add_option("ARCHIVE", archive, "the .tar.gz to write")->required();
  CLI::App* const verifying =
      app.add_subcommand("verify", "checks the checksums and the must-pass list of such an archive");
  verifying->add_option("ARCHIVE", archive)->required();
  CLI::App* const worker = app.add_subcommand("worker", "the process in which cases run")->group("");
  worker->add_option("TASK", task)->required()->check(CLI::IsMember({"describe", "run", "show"}));
  worker->add_option("NAMES", names);
  worker->fallthrough();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_status::passed : exit_status::usage;
  }
  if (worker->parsed()) {
    options.run.api = api_of(options.api);
    return work(task_of(task), options.run, names, 3);
  }
  if (packaging->parsed()) return make_package(directory, archive);
  if (verifying->parsed()) return check_package(archive);
  return judge(options, {argv, argv + argc});
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    return try_program(argc, argv);
  } catch (const Complaint& complaint) {
    std::fprintf(stderr, "glark-conformance: %s\n", complaint.text.c_str());
    return complaint.status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glark-conformance: %s\n", error.what());
    return exit_status::failed;
  }
}

}  // namespace glark::conformance
