#include "certify/trace_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// A line of nine axes is far shorter; a file without line ends must not fill the memory.
constexpr std::size_t kLongestLine = 1 << 16;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// Calls `each(field, column)` for every field between commas; the column is that of its first character, from 1.
template <class Function>
void for_each_field(std::string_view line, Function each) {
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::size_t first = begin;
    while (first < end && (line[first] == ' ' || line[first] == '\t')) ++first;
    each(trimmed(line.substr(begin, end - begin)), first + 1);
    if (end == line.size()) return;
    begin = end + 1;
  }
}

}  // namespace

TraceReader::TraceReader(std::istream& stream, std::string file, const spec::Axes& axes)
    : stream_(stream), file_(std::move(file)) {
  read_header(axes);
}

void TraceReader::fail(std::size_t column, const std::string& what) const {
  throw spec::InputError(file_, line_, column, what);
}

bool TraceReader::next_line() {
  text_.clear();
  std::streambuf& in = *stream_.rdbuf();
  bool any = false;
  for (int c = in.sbumpc(); c != std::char_traits<char>::eof(); c = in.sbumpc()) {
    if (!any) ++line_;
    any = true;
    if (c == '\n') break;
    text_ += std::char_traits<char>::to_char_type(c);
    if (c == '\0') fail(text_.size(), "a NUL: this is no text");
    if (text_.size() > kLongestLine) fail(text_.size(), "a line of more than 65536 bytes");
  }
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return any;
}

void TraceReader::read_header(const spec::Axes& axes) {
  do {
    if (!next_line()) {
      line_ = std::max<std::uint64_t>(line_, 1);
      fail(1, "no header: the first line names the columns, as in time,X,Y,Z");
    }
    if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  } while (trimmed(text_).empty());
  for_each_field(text_, [&](std::string_view field, std::size_t column) {
    std::string name(field);
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    std::size_t index = spec::Axes::kNone;
    if (name == "TIME" || name == "T") {
      index = kTime;
    } else {
      if (name.size() == 1) index = axes.index(name[0]);
      if (index == spec::Axes::kNone)
        fail(column,
             "a column is time or an axis of the setup (" + axes.letters() + "), not \"" + std::string(field) + "\"");
      recorded_.push_back(index);
    }
    if (std::ranges::find(columns_, index) != columns_.end()) fail(column, "column " + name + " occurs twice");
    columns_.push_back(index);
  });
  if (recorded_.empty()) fail(1, "no axis is recorded");
}

double TraceReader::number(std::string_view text, std::size_t column) const {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value))
    fail(column, text.empty() ? std::string("a number is missing") : "\"" + std::string(text) + "\" is no number");
  return value;
}

bool TraceReader::next(TraceSample& sample) {
  do {
    if (!next_line()) return false;
  } while (trimmed(text_).empty());
  sample.line = line_;
  std::size_t index = 0;
  for_each_field(text_, [&](std::string_view field, std::size_t column) {
    if (index == columns_.size()) fail(column, "more values than columns");
    const double value = number(field, column);
    if (columns_[index] == kTime) {
      if (time_ && value < *time_) fail(column, "time runs backwards");
      time_ = value;
    } else {
      sample.axes.set(columns_[index], value);
    }
    ++index;
  });
  if (index < columns_.size()) fail(text_.size() + 1, "fewer values than columns");
  return true;
}

}  // namespace toolcomp::certify
