// SPDX-License-Identifier: Apache-2.0
// A campaign on the screen: on a terminal a board that is drawn again every second, elsewhere a line now and then; both
// on standard error, and neither with --quiet.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "certify/fuzzing/board.h"

namespace toolcomp::cli {

class Board {
 public:
  Board();
  ~Board();
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void show(const certify::fuzzing::BoardView& view);
  // What happened, above the board.
  void say(const std::string& line);
  // The board goes: what comes next stands in its place.
  void close();

 private:
  void clear();

  bool terminal_;
  std::size_t drawn_ = 0;  // lines
  host::Clock::time_point next_;
};

}  // namespace toolcomp::cli
