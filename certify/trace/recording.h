// SPDX-License-Identifier: Apache-2.0
// Reads recorded axis positions: the CSV of a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/trace/samples.h"
#include "spec/language/axes.h"
#include "spec/parameters/keys.h"

namespace toolcomp::certify {

// Reads samples one by one in constant memory. The first line names the columns, in any order and each once: axes of
// the setup and `time` or `t`, in upper or lower case. A unit may follow the name, as in `X [mm]`, `Y_in`, `C (deg)`,
// `time_ms`: lengths um, mm, m, in, inch; angles deg, rad; time us, ms, s. Without a unit, lengths are in the given
// units, angles in degrees, time in seconds. Time must not run backwards. Columns are separated by comma, semicolon or
// tab, the same in the whole file. Blank lines and lines that begin with # are skipped; blanks around numbers, a byte
// order mark and CRLF are allowed. Anything else is a spec::InputError with line and column.
class Recording : public SampleSource {
 public:
  Recording(std::istream& stream, std::string file, const spec::Axes& axes, spec::Units units);
  bool next(RecordedSample& sample) override;
  // In the order of the columns.
  [[nodiscard]] const std::vector<std::size_t>& recorded() const override { return recorded_; }
  [[nodiscard]] bool has_time() const override { return has_time_; }

 private:
  static constexpr std::size_t kTime = spec::kMaxAxes;
  struct Column {
    std::size_t index = kTime;  // of the axis, or kTime
    double scale = 1;
  };
  bool fill();
  bool next_line();
  void read_header(const spec::Axes& axes, spec::Units units);
  [[nodiscard]] char separator() const;
  [[nodiscard]] Column column(std::string_view field, std::size_t at, const spec::Axes& axes, spec::Units units) const;
  [[nodiscard]] double number(std::string_view text, std::size_t column) const;
  void take_time(RecordedSample& sample, double seconds, double scale, std::string_view text, std::size_t column);
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  std::istream& stream_;
  std::string file_;
  std::string buffer_;
  std::size_t begin_ = 0;  // begin of the unread part
  std::uint64_t line_ = 0;
  std::string text_;
  char separator_ = ',';
  std::vector<Column> columns_;
  std::vector<std::size_t> recorded_;
  bool has_time_ = false;
  std::optional<double> time_;
};

}  // namespace toolcomp::certify
