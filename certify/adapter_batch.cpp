// SPDX-License-Identifier: Apache-2.0
#include "certify/adapter_batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host/file_writer.h"
#include "host/process.h"
#include "host/temporary_folder.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {

namespace fs = std::filesystem;

fs::path batch_folder(const fs::path& batch, std::size_t index) { return batch / fmt::format("{:04}", index + 1); }

void write_program(const fs::path& folder, const spec::Case& c) {
  host::write_file(folder / "program.nc", c.program);
  host::write_file(folder / "setup.json", spec::write_setup_json(c.setup) + "\n");
}

std::optional<std::string> first_line(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  if (!in) return std::nullopt;
  std::getline(in, line);
  return line;
}

std::vector<KnownPlace> read_known_places(const fs::path& file, const Adapter& adapter) {
  std::vector<KnownPlace> places;
  std::ifstream in(file);
  std::uint64_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    KnownPlace place;
    std::string rest;
    if (!(words >> place.id >> place.first >> place.last) || words >> rest)
      throw spec::InputError(file.string(), number, 1, "expected ID FIRST LAST");
    if (adapter.known_difference(place.id) == nullptr)
      throw spec::InputError(file.string(), number, 1, "there is no known difference \"" + place.id + "\"");
    places.push_back(std::move(place));
  }
  return places;
}

std::string run_adapter(const Adapter& adapter, const std::string& option, const fs::path& batch, std::size_t programs,
                        std::chrono::milliseconds timeout, const std::function<void(const std::string&)>& progress,
                        const std::function<std::string()>& stop) {
  constexpr std::size_t kLongestLine = 65536;
  std::vector<std::string> arguments{fs::absolute(batch).string()};
  if (!option.empty()) arguments.insert(arguments.begin(), option);
  // What it writes to standard output is nobody's.
  host::Process process("{ " + adapter.shell_command(arguments) + "; } 2>&1 >/dev/null");
  constexpr std::int64_t kStart = 6;  // programs: what it may take to come and go
  const auto wait = (kStart + static_cast<std::int64_t>(programs)) * timeout;
  const host::Clock::time_point deadline = host::Clock::now() + wait;
  std::string line;
  std::string last;
  host::Exchange end = host::Exchange::line;
  const auto go_on = [&] {
    if (stop && !stop().empty()) return false;
    return end == host::Exchange::line || (end == host::Exchange::timed_out && host::Clock::now() < deadline);
  };
  do {
    constexpr std::chrono::milliseconds kLook{200};
    end = process.receive_line(line, std::min(deadline, host::Clock::now() + kLook), kLongestLine);
    if (end != host::Exchange::line) continue;
    if (progress) progress(line);
    last = line;
  } while (go_on());
  const std::string ended = process.finish(std::chrono::seconds(end == host::Exchange::closed ? 10 : 0));
  if (end == host::Exchange::timed_out) return fmt::format("did not end within {} ms", wait.count());
  if (process.exit_status() != 0) return ended + (last.empty() ? "" : ": " + last);
  return {};
}

std::vector<std::string> why_not(const Adapter& adapter, const std::vector<spec::Case>& cases) {
  constexpr std::chrono::seconds kTimeout{10};
  if (adapter.kind != AdapterKind::trace)
    throw spec::InputError(adapter.name, 0, 0, "only an adapter of kind trace can say in advance what it cannot run");
  const host::TemporaryFolder batch;
  for (std::size_t i = 0; i < cases.size(); ++i) write_program(batch_folder(batch.path(), i), cases[i]);
  const std::string wrong = run_adapter(adapter, "--ask", batch.path(), cases.size(), kTimeout, {});
  if (!wrong.empty()) throw spec::InputError(adapter.name, 0, 0, "was asked what it cannot run, and failed: " + wrong);
  std::vector<std::string> answers;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const fs::path folder = batch_folder(batch.path(), i);
    const std::vector<KnownPlace> known = read_known_places(folder / "known.txt", adapter);
    if (const auto absent = first_line(folder / "not_applicable.txt"))
      answers.push_back(adapter.name + " does not have: " + *absent);
    else
      answers.push_back(known.empty() ? "" : adapter.name + " is known to differ: " + known.front().id);
  }
  return answers;
}

}  // namespace toolcomp::certify
