// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "certify/fuzzing/third_voice.h"
#include "fuzz/campaign/black_box.h"
#include "fuzz/campaign/diary.h"
#include "host/file_writer.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;

// Exit statuses of libFuzzer, and the first of a shell that stands for a signal.
constexpr int kHang = 70;
constexpr int kOutOfMemory = 71;
constexpr int kCrash = 77;
constexpr int kSignalled = 128;
constexpr std::chrono::milliseconds kToEnd{2000};
// libFuzzer's schedule by entropy takes three times as long as an execution of ours: so much is rare in each.
constexpr const char* kSchedule = "-entropic=0";
// Between two looks at the black box.
constexpr std::chrono::milliseconds kLook{250};
constexpr const char* kKilled = "killed by signal 9";

std::string word(const fs::path& path) { return ' ' + host::shell_quoted(fs::absolute(path).string()); }

std::string libfuzzer(const Bench& bench, const Slice& slice, const fs::path& folder, const fs::path& corpus) {
  const fuzz::Target& target = *slice.target;
  std::string line =
      fmt::format("TOOLCOMP_FUZZ_WORK={} TOOLCOMP_FUZZ_SEED={}{} -seed={} -verbosity=0 -max_len=16384 {}",
                  host::shell_quoted(fs::absolute(folder).string()), slice.seed, word(bench.targets / target.name),
                  slice.seed, kSchedule);
  line += slice.runs > 0 ? fmt::format(" -runs={}", slice.runs) : fmt::format(" -max_total_time={}", slice.seconds);
  line += fmt::format(" -timeout={} -artifact_prefix={}", bench.patience.count() / 2,
                      host::shell_quoted(fs::absolute(folder).string() + "/"));
  line += word(corpus);
  for (const fs::path& inputs : bench.inputs)
    if (fs::is_directory(inputs / target.seeds)) line += word(inputs / target.seeds);
  return line;
}

std::string built_in(const Bench& bench, const Slice& slice, const fs::path& folder, const fs::path& corpus) {
  const fuzz::Target& target = *slice.target;
  std::string line = fmt::format("{} fuzz-worker --target {} --seed {} --work{} --corpus{}", word(bench.program),
                                 target.name, slice.seed, word(folder), word(corpus));
  line += slice.runs > 0 ? fmt::format(" --runs {}", slice.runs) : fmt::format(" --seconds {}", slice.seconds);
  for (const fs::path& inputs : bench.inputs)
    if (fs::is_directory(inputs / target.seeds)) line += " --inputs" + word(inputs / target.seeds);
  if (!bench.controller.empty())
    line += fmt::format(" --timeout {} --controller {}", bench.timeout, host::shell_quoted(bench.controller));
  return line;
}

std::string specification(const Bench& bench, const Slice& slice, const fs::path& folder, const fs::path& corpus) {
  std::string line =
      fmt::format("{} fuzz-specification --seed {} --seconds {} --work{} --corpus{} --asked{}", word(bench.program),
                  slice.seed, slice.seconds, word(folder), word(corpus), word(corpus.parent_path() / "asked"));
  for (const fuzz::Target* target : slice.heard) line += " --target " + target->name;
  return line;
}

// The worker ends with this process, even if it is killed: then its standard input ends. Standard output is the shell's
// alone, so that it ends with the shell, even if that is killed.
std::string script(const std::string& worker) {
  return "exec 3<&0\n{ cat <&3; kill -KILL 0; } >/dev/null &\nwatcher=$!\n" + worker +
         " </dev/null >/dev/null\nstatus=$?\nkill -KILL $watcher\nexit $status\n";
}

std::string prepared(const Bench& bench, const Slice& slice, const fs::path& folder, const fs::path& corpus) {
  fs::create_directories(folder / fuzz::Diary::kFindings);
  fs::create_directories(corpus);
  host::write_file(folder / "target", slice.target->name + "\n");
  if (slice.target == &third_voice()) return script(specification(bench, slice, folder, corpus));
  return script(bench.has_clang(*slice.target) ? libfuzzer(bench, slice, folder, corpus)
                                               : built_in(bench, slice, folder, corpus));
}

}  // namespace

bool Bench::has_clang(const fuzz::Target& target) const {
  return controller.empty() && !targets.empty() && fs::exists(targets / target.name);
}

bool Bench::can_run(const fuzz::Target& target) const { return !target.is_reader() || has_clang(target); }

Worker::Worker(const Bench& bench, const Slice& slice, fs::path folder, const fs::path& corpus)
    : slice_(slice),
      folder_(std::move(folder)),
      patience_(bench.patience),
      process_(prepared(bench, slice, folder_, corpus)) {}

bool Worker::goes_on(std::chrono::milliseconds wait) {
  if (ended_ != host::Clock::time_point{}) return false;
  std::string nothing;
  const host::Exchange heard = process_.receive_line(nothing, host::Clock::now() + wait, 1024);
  if (heard == host::Exchange::closed || host::Clock::now() - looked_ >= kLook) look();
  if (heard == host::Exchange::closed) {
    process_.finish(kToEnd);
    const int status = process_.exit_status();
    // Without one the shell itself was killed, and the worker with it: from outside.
    end(status < 0                            ? kKilled
        : status == 0                         ? ""
        : status == kHang                     ? "hang"
        : status == kOutOfMemory              ? "out of memory"
        : status == kCrash                    ? "crash"
        : status == fuzz::Diary::kCannotWrite ? "cannot write"
        : status > kSignalled                 ? fmt::format("killed by signal {}", status - kSignalled)
                                              : fmt::format("exit status {}", status));
    return false;
  }
  if (host::Clock::now() - moved_ < patience_) return true;
  process_.finish();
  end("hang");
  return false;
}

void Worker::stop() {
  if (ended_ != host::Clock::time_point{}) return;
  look();
  process_.finish();
  end("");
}

void Worker::look() {
  looked_ = host::Clock::now();
  const auto box = fuzz::BlackBox::read(folder_ / fuzz::Diary::kBlackBox);
  if (!box) return;
  process_number_ = box->process;
  if (box->executions != executions_) moved_ = host::Clock::now();
  executions_ = box->executions;
}

// An end that libFuzzer did not see leaves no input of its own; the black box has it. A kill from outside is no fault
// of the input.
void Worker::end(std::string how) {
  ended_ = host::Clock::now();
  how_ = std::move(how);
  const bool told = how_.empty() || how_ == "cannot write" || how_ == kKilled || how_ == "killed by signal 15";
  if (told) return;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("crash-") || name.starts_with("timeout-") || name.starts_with("oom-")) return;
  }
  const auto box = fuzz::BlackBox::read(folder_ / fuzz::Diary::kBlackBox);
  if (!box || box->executions == 0) return;
  if (slice_.target == &third_voice()) {
    host::write_file(folder_ / fuzz::Diary::kFindings / (fuzz::digest(box->input) + ".json"),
                     ended_at(box->input, how_ == "hang" || how_ == "out of memory" ? how_ : "crash"));
    return;
  }
  const char* const kind = how_ == "hang" ? "timeout-" : how_ == "out of memory" ? "oom-" : "crash-";
  host::write_file(folder_ / (kind + fuzz::digest(box->input)), box->input);
}

std::uint64_t Worker::milliseconds() const {
  const host::Clock::time_point until = ended_ == host::Clock::time_point{} ? host::Clock::now() : ended_;
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(until - begun_).count());
}

fuzz::Counters counters_in(const fs::path& folder) {
  const fs::path file = folder / fuzz::Diary::kStatistics;
  return fs::exists(file) ? fuzz::read_counters(spec::read_file(file.string())) : fuzz::Counters{};
}

}  // namespace toolcomp::certify::fuzzing
