// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/run.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/wait.h>

#include <cstring>
#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "conformance/runner/process.h"

namespace glark::conformance {
namespace {

std::vector<std::string> arguments_of(const RunOptions& options, const char* task) {
  std::vector<std::string> texts = {"worker",     task,
                                    "--platform", options.platform,
                                    "--api",      std::string(name_of(options.api)),
                                    "--seed",     std::to_string(options.seed),
                                    "--report",   options.report};
  if (!options.implementation.empty()) texts.insert(texts.end(), {"--implementation", options.implementation});
  if (options.notes_commands) texts.emplace_back("--commands");
  return texts;
}

// A process and its cases.
class Worker {
 public:
  Worker(std::vector<Record*> records, const RunOptions& options)
      : records_(std::move(records)),
        process_(arguments(records_, options), options.implementation),
        limit_(options.seconds) {}

  Process& process() { return process_; }
  bool is_finished() const { return done_ == records_.size(); }
  Record& current() { return *records_[done_]; }
  std::vector<Record*> left() const { return {records_.begin() + static_cast<std::ptrdiff_t>(done_), records_.end()}; }
  // Returns why the current case must end, or nothing.
  std::optional<std::string> is_late() { return limit_.exceeded(process_.used()); }

  // Reads new messages. Returns false once the process has closed its report.
  bool listen(const Progress& progress) {
    process_.read_output(output_);
    const bool open = process_.read_report(text_);
    for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n')) {
      take(nlohmann::json::parse(text_.substr(0, end), nullptr, false), progress);
      text_.erase(0, end + 1);
    }
    return open;
  }

  // Records the case that was running, or that never began, when the process ended.
  void blame(Verdict verdict, const std::string& why, const Progress& progress) {
    process_.read_output(output_);
    Record& record = current();
    record.messages.push_back(why);
    finish(record, verdict, progress);
  }

 private:
  static std::vector<std::string> arguments(const std::vector<Record*>& records, const RunOptions& options) {
    std::vector<std::string> texts = arguments_of(options, "run");
    for (const Record* record : records) texts.push_back(record->name);
    return texts;
  }

  void take(const nlohmann::json& message, const Progress& progress) {
    if (message.is_discarded() || is_finished()) return;
    if (message.contains("error")) {
      current().messages.push_back(message["error"]);
    } else if (message.contains("end") && message["end"] == current().name) {
      Record& record = current();
      for (const auto& text : message["messages"]) record.messages.push_back(text);
      for (const auto& path : message["images"]) record.images.push_back(path);
      for (const auto& command : message["commands"]) record.commands.push_back(command);
      finish(record, verdict_of(message["verdict"].get<std::string>()).value_or(Verdict::internal_error), progress);
    }
  }

  void finish(Record& record, Verdict verdict, const Progress& progress) {
    record.verdict = record.seen = verdict;
    const TimeUsed now = process_.used();
    record.seconds = now.clock - case_began_;
    record.output = std::move(output_);
    output_.clear();
    case_began_ = now.clock;
    limit_.begin(now);
    record.is_over = true;
    ++done_;
    if (!progress(record)) records_.resize(done_);
  }

  std::vector<Record*> records_;
  std::size_t done_ = 0;
  Process process_;
  TimeLimit limit_;
  double case_began_ = 0;  // in seconds after the start of the process
  std::string text_;
  std::string output_;
};

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return std::string("its process was ended by ") + strsignal(WTERMSIG(status));
  return fmt::format("its process ended with status {} and no result", WEXITSTATUS(status));
}

// Runs the cases in processes. If a process ends early or takes too long, its current case gets the blame, and a new
// process gets the rest.
class Scheduler {
 public:
  Scheduler(std::vector<Record>& records, const RunOptions& options, const Progress& progress)
      : options_(options), progress_([this, &progress](const Record& record) {
          is_stopped_ = !progress(record) || is_stopped_;
          return !is_stopped_;
        }) {
    std::vector<Record*> batch;
    for (Record& record : records) {
      batch.push_back(&record);
      if (batch.size() == static_cast<std::size_t>(options.cases_in_process))
        waiting_.push_back(std::exchange(batch, {}));
    }
    if (!batch.empty()) waiting_.push_back(batch);
  }

  void run() {
    while (!waiting_.empty() || !workers_.empty()) {
      while (!waiting_.empty() && workers_.size() < static_cast<std::size_t>(options_.jobs)) {
        workers_.push_back(std::make_unique<Worker>(waiting_.front(), options_));
        waiting_.pop_front();
      }
      wait_for_news();
      for (std::size_t i = 0; i < workers_.size();) {
        if (is_over(*workers_[i])) {
          workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
        } else {
          ++i;
        }
      }
      if (is_stopped_) waiting_.clear();
    }
  }

 private:
  void wait_for_news() {
    std::vector<pollfd> descriptors;
    for (const auto& worker : workers_) {
      descriptors.push_back({worker->process().report_descriptor(), POLLIN, 0});
      descriptors.push_back({worker->process().output_descriptor(), POLLIN, 0});
    }
    poll(descriptors.data(), descriptors.size(), 200);
  }

  bool is_over(Worker& worker) {
    const bool open = worker.listen(progress_);
    if (worker.is_finished()) {
      // The last case has reported, so a driver that hangs at exit does not change its verdict.
      worker.process().kill();
      worker.process().wait();
      return true;
    }
    if (!open) {
      const int status = worker.process().wait();
      worker.blame(WIFSIGNALED(status) ? Verdict::crash : Verdict::missing, how_it_ended(status), progress_);
    } else if (const auto why = worker.is_late()) {
      worker.process().kill();
      worker.process().wait();
      worker.blame(Verdict::timeout, *why, progress_);
    } else {
      return false;
    }
    if (!worker.is_finished()) waiting_.push_front(worker.left());
    return true;
  }

  const RunOptions& options_;
  const Progress progress_;
  bool is_stopped_ = false;
  std::deque<std::vector<Record*>> waiting_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

bool is_worth_a_retry(const Record& record) {
  return is_bad(record.verdict) && record.verdict != Verdict::internal_error;
}

void retry(std::vector<Record>& records, const RunOptions& options) {
  for (Record& record : records) {
    for (int i = 0; i < options.retries && is_worth_a_retry(record); ++i) {
      std::vector<Record> again(1);
      again.front().name = record.name;
      Scheduler(again, options, [](const Record&) { return true; }).run();
      if (is_bad(again.front().verdict)) continue;
      record.messages.push_back("passed when run again; before: " + std::string(name_of(record.verdict)) + " before");
      record.verdict = Verdict::flake;
    }
  }
}

// What a process of its own says, in one message. Throws std::runtime_error and std::invalid_argument.
nlohmann::json ask(const std::vector<std::string>& arguments, const RunOptions& options) {
  Process process(arguments, options.implementation);
  std::string text;
  std::string output;
  TimeLimit limit(options.seconds);
  std::optional<std::string> late;
  while (!late && process.read_report(text)) {
    std::array<pollfd, 2> news = {pollfd{process.report_descriptor(), POLLIN, 0},
                                  pollfd{process.output_descriptor(), POLLIN, 0}};
    poll(news.data(), news.size(), 200);
    process.read_output(output);
    late = limit.exceeded(process.used());
  }
  if (late) process.kill();
  process.read_output(output);
  const int status = process.wait();
  auto message = nlohmann::json::parse(text, nullptr, false);
  if (message.is_discarded()) {
    const std::string why = late ? *late : how_it_ended(status);
    throw std::runtime_error("no answer: " + why + (output.empty() ? "" : '\n' + output));
  }
  if (message.contains("not loaded")) throw std::invalid_argument(message["not loaded"].get<std::string>() + output);
  if (message.contains("error")) throw std::runtime_error(message["error"].get<std::string>());
  return message;
}

}  // namespace

Environment describe_environment(const RunOptions& options) {
  return ask(arguments_of(options, "describe"), options)["environment"].get<Environment>();
}

std::string show_case(const std::string& name, const RunOptions& options) {
  std::vector<std::string> arguments = arguments_of(options, "show");
  arguments.push_back(name);
  return ask(arguments, options)["shown"].get<std::string>();
}

std::vector<Record> run(const std::vector<std::string>& names, const RunOptions& options, const Progress& progress) {
  std::vector<Record> records;
  for (const std::string& name : names) records.emplace_back().name = name;
  Scheduler(records, options, progress).run();
  std::erase_if(records, [](const Record& record) { return !record.is_over; });
  retry(records, options);
  return records;
}

}  // namespace glark::conformance
