// Recorded axis positions: the CSV of a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/axes.h"

namespace toolcomp::certify {

struct TraceSample {
  std::uint64_t line = 0;  // of the file, from 1
  spec::AxisValues<double> axes;
};

// Reads samples one by one in constant memory. The first line names the columns: `time` (optional, seconds, never
// running backwards) and axes of the setup, each at most once. Blank lines are skipped; blanks around numbers, a byte
// order mark and CRLF are allowed. Anything else is a spec::InputError with line and column.
class TraceReader {
 public:
  TraceReader(std::istream& stream, std::string file, const spec::Axes& axes);
  // The next sample; false at the end.
  bool next(TraceSample& sample);
  // The axes that are recorded, by index, in the order of the columns.
  [[nodiscard]] const std::vector<std::size_t>& recorded() const { return recorded_; }

 private:
  static constexpr std::size_t kTime = spec::kMaxAxes;
  bool next_line();
  void read_header(const spec::Axes& axes);
  [[nodiscard]] double number(std::string_view text, std::size_t column) const;
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  std::istream& stream_;
  std::string file_;
  std::uint64_t line_ = 0;
  std::string text_;
  std::vector<std::size_t> columns_;  // axis index, or kTime
  std::vector<std::size_t> recorded_;
  std::optional<double> time_;
};

}  // namespace toolcomp::certify
