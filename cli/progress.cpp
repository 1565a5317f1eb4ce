// SPDX-License-Identifier: Apache-2.0
#include "cli/progress.h"

#include <chrono>
#include <iostream>

#include "cli/manners.h"

namespace toolcomp::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kInterval = std::chrono::milliseconds(200);

const char* unit_shown = nullptr;  // null: no terminal, or nothing to show
Clock::time_point last_shown;
bool line_open = false;

void show(const std::string& text) {
  const auto now = Clock::now();
  if (now - last_shown < kInterval) return;
  last_shown = now;
  line_open = true;
  std::cerr << '\r' << first_characters(text, columns_of(Stream::err) - 1) << "\033[K" << std::flush;
}

}  // namespace

Progress::Progress(const char* unit) { unit_shown = can_redraw() ? unit : nullptr; }

Progress::~Progress() {
  if (line_open) std::cerr << "\r\033[K" << std::flush;
  line_open = false;
  unit_shown = nullptr;
}

void Progress::count(std::uint64_t done) {
  if (unit_shown != nullptr) show(std::to_string(done) + ' ' + unit_shown);
}

void Progress::line(const std::string& text) {
  if (unit_shown != nullptr) show(text);
}

}  // namespace toolcomp::cli
