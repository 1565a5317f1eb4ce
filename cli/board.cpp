// SPDX-License-Identifier: Apache-2.0
#include "cli/board.h"
#include "cli/manners.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace toolcomp::cli {
namespace {

// Between two plain lines.
constexpr std::chrono::seconds kPlain{10};

struct Size {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

Size size_of_terminal() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

}  // namespace

Board::Board() : terminal_(can_redraw()), next_(host::Clock::now() + kPlain) {}

Board::~Board() { close(); }

void Board::show(const certify::fuzzing::BoardView& view) {
  if (is_quiet()) return;
  if (!terminal_) {
    if (host::Clock::now() < next_) return;
    next_ = host::Clock::now() + kPlain;
    std::cerr << certify::fuzzing::plain_line(view) << std::endl;
    return;
  }
  clear();
  const Size size = size_of_terminal();
  std::vector<std::string> lines = certify::fuzzing::board_lines(view);
  // Where the terminal is low, what fits of the targets and the line at the end.
  if (lines.size() >= size.rows && size.rows > 2)
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(size.rows) - 2, lines.end() - 1);
  for (const std::string& line : lines) std::cerr << first_characters(line, size.columns - 1) << '\n';
  drawn_ = lines.size();
  std::cerr << std::flush;
}

void Board::say(const std::string& line) {
  clear();
  if (!is_quiet()) std::cerr << line << std::endl;
}

void Board::close() { clear(); }

void Board::clear() {
  if (drawn_ > 0) std::cerr << fmt::format("\033[{}A\033[J", drawn_);
  drawn_ = 0;
}

}  // namespace toolcomp::cli
