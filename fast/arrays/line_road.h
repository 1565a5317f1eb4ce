// SPDX-License-Identifier: Apache-2.0
// The way of a program from its reader to an engine: usual lines many at once, everything else block by block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "fast/arrays/line_moves.h"
#include "spec/language/line_columns.h"

namespace toolcomp::fast {

struct Nobody {
  template <class... Anything>
  void operator()(const Anything&... /*anything*/) const {}
};

class LineRoad {
 public:
  // From so many on arrays pay.
  static constexpr std::size_t kFewest = 8;

  // `to`: takes the moves of lines that go together; otherwise they are events of the engine's sink. `fewest`: fewer
  // lines than these go alone.
  explicit LineRoad(LineSink* to = nullptr, std::size_t fewest = kFewest) : to_(to), fewest_(fewest) {}

  // Runs the rest of the program. `on_block` sees every block that goes alone before the engine takes it; `on_lines`
  // sees the lines that have gone together: columns, and how many of them.
  template <class Reader, class Engine, class Block, class OnBlock = Nobody, class OnLines = Nobody>
  void run(Reader& reader, Engine& engine, Block& block, const OnBlock& on_block = {}, const OnLines& on_lines = {}) {
    pause_ = longer_pause_ = 0;
    while (!engine.stopped() && reader.next(block)) {
      on_block(block);
      engine.block(block);
      if constexpr (requires { Engine::kEventsOfLines; })
        if ((Engine::kEventsOfLines || to_ != nullptr) && is_time() && lines_may_follow(block))
          take_lines(reader, engine, on_lines);
    }
  }

 private:
  // Whether lines are tried after this block.
  [[nodiscard]] bool is_time() {
    if (pause_ > 0) --pause_;
    return pause_ == 0;
  }
  // Lines after a block: as many as the engine takes, more at a time as long as it takes all of them. Where it takes
  // few, it is asked less often.
  template <class Reader, class Engine, class OnLines>
  void take_lines(Reader& reader, Engine& engine, const OnLines& on_lines) {
    std::size_t all = 0;
    for (std::size_t most = fewest_;; most = std::min(2 * most, spec::LineColumns::kMost)) {
      reader.lines(*lines_, most);
      // Those that are read already pay from half of it on.
      const bool pays = lines_->size >= (all == 0 ? fewest_ : (fewest_ + 1) / 2);
      const std::size_t taken = pays ? engine.lines(*lines_, to_) : 0;
      if (taken > 0) {
        on_lines(*lines_, taken);
        reader.pass_lines(taken);
        all += taken;
      }
      if (taken < most) break;
    }
    longer_pause_ = all >= fewest_ ? 0 : std::min(2 * longer_pause_ + 1, kLongestPause);
    pause_ = longer_pause_;
  }

  static constexpr std::size_t kLongestPause = 64;
  LineSink* to_;
  std::size_t fewest_;
  std::unique_ptr<spec::LineColumns> lines_ = std::make_unique<spec::LineColumns>();
  std::size_t pause_ = 0, longer_pause_ = 0;  // blocks until lines are tried again
};

}  // namespace toolcomp::fast
