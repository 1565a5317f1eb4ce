// SPDX-License-Identifier: Apache-2.0
// The differences between the dialects: the engine, and how a block is made from words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "fast/arrays/line_chunk.h"
#include "fast/arrays/line_moves.h"
#include "fast/basis/event.h"
#include "spec/language/decimal.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Decimal places of the whole numbers in a LineChunk.
inline constexpr unsigned kLengthPlaces = 6;
inline constexpr unsigned kVectorPlaces = 8;
inline constexpr double kMostLength = 0x1p50;
inline constexpr double kMostVector = 1e9;

// Makes a block word by word.
class BlockMaker {
 public:
  virtual ~BlockMaker() = default;
  // std::nullopt if it is not a word of a line.
  [[nodiscard]] virtual std::optional<std::size_t> place_of(std::string_view word) const = 0;
  virtual void begin(std::uint64_t line, std::uint32_t words) = 0;
  virtual void set(std::size_t place, const spec::Decimal& value) = 0;
};

class BatchEngine {
 public:
  virtual ~BatchEngine() = default;
  // Runs the blocks of a text, whose line numbers follow `before`. Returns the number of its lines.
  virtual std::uint64_t run(std::string_view text, std::uint64_t before) = 0;
  [[nodiscard]] virtual BlockMaker& maker() = 0;
  // Takes the block that was made.
  virtual void block() = 0;
  [[nodiscard]] virtual std::size_t lines(const LineChunk& chunk) = 0;
  virtual void end() = 0;
  [[nodiscard]] virtual bool stopped() const = 0;
};

// Makes the engine for the control of the setup. `lines`: as LineRoad. `samples`: the number of parts into which a
// block under tool center point control is divided; 0: no samples.
std::unique_ptr<BatchEngine> make_batch_engine(const spec::Setup& setup, EventSink& sink, LineSink* lines = nullptr,
                                               std::uint32_t samples = 0);

}  // namespace toolcomp::fast
