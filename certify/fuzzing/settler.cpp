// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/settler.h"

#include <fmt/format.h>

#include <array>

#include "fuzz/campaign/diary.h"
#include "host/file_writer.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
constexpr std::chrono::seconds kPatience{180};  // with one sighting
// For its line; with no time at all nothing is read.
constexpr std::chrono::milliseconds kLook{1};

std::string group_of(const Finding& seen) {
  return fmt::format("{}|{}|{}", seen.key.section.empty() ? seen.target : seen.key.section, seen.key.kind,
                     seen.key.clause);
}

std::string explained(const Dossier& dossier) {
  const Finding& f = dossier.finding;
  std::string text = fmt::format("{}, {}", f.key.section.empty() ? f.target : f.key.section, f.key.kind);
  if (!f.key.clause.empty()) text += ", " + f.key.clause;
  text += fmt::format(" ({})", name(dossier.stage));
  return text;
}

}  // namespace

Settled settle_file(const Folder& folder, const fs::path& file, const std::string& target,
                    const std::string& why_as_seen, const SettleOptions& options) {
  Finding seen = read_sighting(file, target);
  if (seen.target.empty()) seen.target = target;
  Dossier dossier;
  if (why_as_seen.empty()) {
    dossier = settle(seen, options);
  } else {
    dossier.finding = seen;
    dossier.finding.complete = false;
    dossier.why = why_as_seen;
  }
  Settled settled;
  settled.open = seen.key.kind == fuzz::kUndecidedKind;
  settled.name = dossier.name();
  settled.everywhere = fails_everywhere(dossier);
  settled.words = explained(dossier);
  settled.fresh = write_dossier(dossier, (settled.open ? folder.open() : folder.findings()) / settled.name);
  return settled;
}

std::string write_settled(const Settled& settled) {
  return fmt::format("{} {:d} {:d} {:d} {}", settled.name, settled.fresh, settled.open, settled.everywhere,
                     settled.words);
}

std::optional<Settled> read_settled(const std::string& line) {
  std::array<std::string, 4> word;
  std::size_t from = 0;
  for (std::string& w : word) {
    const std::size_t end = line.find(' ', from);
    if (end == std::string::npos) return std::nullopt;
    w = line.substr(from, end - from);
    from = end + 1;
  }
  return Settled{word[0], word[1] == "1", word[2] == "1", word[3] == "1", line.substr(from)};
}

void Settler::step(State& state, const std::function<void(const Settled&)>& on_settled) {
  if (!process_) {
    begin();
    return;
  }
  std::string line;
  constexpr std::size_t kLongest = 1 << 16;
  const host::Exchange heard = process_->receive_line(line, host::Clock::now() + kLook, kLongest);
  if (heard == host::Exchange::timed_out && host::Clock::now() - begun_ < kPatience) return;
  const auto settled = heard == host::Exchange::line ? read_settled(line) : std::nullopt;
  const std::string how = process_->finish(std::chrono::milliseconds(settled ? 2000 : 0));
  const std::string errors = process_->errors();
  const int status = process_->exit_status();
  process_.reset();
  // What it was looking at waits for the next start.
  if (!settled && stopped_()) return;
  if (status == fuzz::Diary::kCannotWrite) throw std::runtime_error(errors);
  if (settled) {
    done(state, *settled, on_settled);
    return;
  }
  if (as_seen_) {
    // Not even that: somebody has to look at the file.
    fs::create_directories(folder_.findings() / "unread");
    fs::rename(at_.file, folder_.findings() / "unread" / at_.file.filename());
    as_seen_ = false;
    return;
  }
  // It stays where it is: the next step keeps it as it was seen.
  failed_ = heard == host::Exchange::timed_out ? fmt::format("examining it took more than {} s", kPatience.count())
                                               : "examining it ended with " + how;
}

void Settler::begin() {
  if (failed_.empty()) {
    const auto waiting = folder_.waiting();
    if (waiting.empty()) return;
    at_ = waiting.front();
    std::string group = at_.target + "|unreadable|";
    try {
      Finding seen = read_sighting(at_.file, at_.target);
      if (seen.target.empty()) seen.target = at_.target;
      group = group_of(seen);
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
      // Whoever looks at it says so.
    }
    const std::uint64_t looked = ++looked_[group];
    if (everywhere_ ? looked > 1 : !fuzz::worth_keeping(looked)) {
      fs::remove(at_.file);
      return;
    }
  }
  std::string line =
      fmt::format("exec {} fuzz-settle --campaign {} --target {} --timeout {} {}",
                  host::shell_quoted(program_.string()), host::shell_quoted(fs::absolute(folder_.root()).string()),
                  at_.target, timeout_, host::shell_quoted(fs::absolute(at_.file).string()));
  as_seen_ = !failed_.empty();
  if (as_seen_) line += " --as-seen " + host::shell_quoted(failed_);
  failed_.clear();
  begun_ = host::Clock::now();
  process_ = std::make_unique<host::Process>(line);
}

void Settler::done(State& state, const Settled& settled, const std::function<void(const Settled&)>& on_settled) {
  if (!settled.open) ++state.groups[settled.name];
  everywhere_ = everywhere_ || settled.everywhere;
  fs::remove(at_.file);
  on_settled(settled);
}

}  // namespace toolcomp::certify::fuzzing
