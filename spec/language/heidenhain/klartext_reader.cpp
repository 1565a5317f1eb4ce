// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_reader.h"

#include <array>
#include <cstring>
#include <utility>

#include "spec/language/heidenhain/klartext_bytes.h"
#include "spec/language/heidenhain/klartext_calls.h"
#include "spec/language/heidenhain/klartext_lines.h"
#include "spec/language/heidenhain/klartext_parser.h"

namespace toolcomp::spec::klartext {
namespace {

constexpr std::size_t kBufferSize = kLongestBlock;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool may_call(const char* statement) {
  const char first = upper(*statement);
  return (first == 'L' && read_word(statement, "LBL") != nullptr) ||
         (first == 'C' && read_word(statement, "CALL") != nullptr);
}

}  // namespace

// The text comes in pieces; a block is parsed once all of it is in the buffer.
struct Reader::State {
  State(std::unique_ptr<ByteSource> bytes, Setup control, ReaderOptions reader_options)
      : source(std::move(bytes)), setup(std::move(control)), options(std::move(reader_options)) {}

  enum class Fetched : std::uint8_t { nothing, block, too_long };

  bool next(Block& block);
  void usual_lines(LineColumns& to, std::size_t most);
  // The next block from `position` on, and how many lines it has.
  Fetched fetch(BlockText& text);
  // More bytes behind those from `position` on; false where there are none, or no room.
  bool refill();
  void skip_byte_order_mark();
  void check_bytes(const BlockText& text, const char* statement) const;
  // The program calls something, or may be called: the rest of the text comes into memory, from this block on.
  void keep_text();
  // The block was read from `text`: goes to the one that comes next.
  void follow(Block& block, const BlockText& text);
  // To behind the end of a block that began at `text` and is longer than the buffer.
  void pass_long(const BlockText& text, const char* statement);

  std::unique_ptr<ByteSource> source;
  Setup setup;
  ReaderOptions options;
  BlockParser parser{setup, options.file};
  std::array<char, kBufferSize + 4 * kDigitsRead> buffer{};
  char* position = buffer.data();
  char* end = buffer.data();
  std::uint64_t line = 1;        // at `position`
  std::uint64_t lines = 1;       // of the block fetched
  std::size_t mark = 0;          // bytes of a byte order mark right before `position`
  std::unique_ptr<Calls> calls;  // with them: `position` and `end` stand in their text
  bool begun = false;
  bool exhausted = false;                            // the source has no more bytes
  bool done = false;                                 // no more blocks
  std::array<char*, LineColumns::kMost> line_end{};  // of the blocks given last
};

bool Reader::State::refill() {
  const auto count = static_cast<std::size_t>(end - position);
  if (exhausted || count == kBufferSize) return false;
  std::memmove(buffer.data(), position, count);
  position = buffer.data();
  end = position + count;
  const std::size_t more = source->read(end, kBufferSize - count);
  end += more;
  exhausted = more == 0;
  return !exhausted;
}

void Reader::State::skip_byte_order_mark() {
  begun = true;
  while (static_cast<std::size_t>(end - position) < kByteOrderMark.size() && refill()) {
  }
  if (!std::string_view(position, static_cast<std::size_t>(end - position)).starts_with(kByteOrderMark)) return;
  mark = kByteOrderMark.size();
  position += mark;
}

Reader::State::Fetched Reader::State::fetch(BlockText& text) {
  if (!begun) skip_byte_order_mark();
  lines = 1;
  const char* line_begin = position;
  const char* from = position;  // no line feed before it, in this line
  for (;;) {
    const auto* feed = static_cast<const char*>(std::memchr(from, '\n', static_cast<std::size_t>(end - from)));
    if (feed != nullptr) {
      const char* last = feed;
      while (last != line_begin && is_blank(last[-1])) --last;
      if (last == line_begin || last[-1] != '~') [[likely]] {
        text = {position, feed, line, mark};
        return feed - position < static_cast<std::ptrdiff_t>(kBufferSize) ? Fetched::block : Fetched::too_long;
      }
      ++lines;
      line_begin = from = feed + 1;
      continue;
    }
    const std::ptrdiff_t begun_at = line_begin - position;
    const std::ptrdiff_t searched = end - position;
    if (refill()) {
      line_begin = position + begun_at;
      from = position + searched;
      continue;
    }
    if (position == end) return Fetched::nothing;
    *end = '\n';  // behind the bytes of the text
    text = {position, end, line, mark};
    return end - position < static_cast<std::ptrdiff_t>(kBufferSize) ? Fetched::block : Fetched::too_long;
  }
}

void Reader::State::check_bytes(const BlockText& text, const char* statement) const {
  ByteCheck check(options.file, text.line, parser.admits_any_byte(statement));
  if (text.mark != 0) check.take_byte_order_mark();
  for (const char* at = text.begin; at <= text.stop; ++at) check.take(*at);
}

void Reader::State::pass_long(const BlockText& text, const char* statement) {
  ByteCheck check(options.file, text.line, parser.admits_any_byte(statement));
  if (text.mark != 0) check.take_byte_order_mark();
  for (;;) {
    for (; position != end; ++position) {
      const bool goes_on = check.is_continued();
      check.take(*position);
      if (*position != '\n' || goes_on) continue;
      ++position;
      line = check.line();
      return;
    }
    if (refill()) continue;
    check.take('\n');
    return;
  }
}

void Reader::State::keep_text() {
  std::string text(position, end);
  for (std::size_t count = 1; !exhausted && count != 0; text.append(buffer.data(), count))
    count = source->read(buffer.data(), kBufferSize);
  exhausted = true;
  calls = std::make_unique<Calls>(setup, options, std::move(text),
                                  Calls::Main{std::string(parser.program_name().view()), parser.units(), line});
  position = calls->data();
  end = position + calls->size();
}

void Reader::State::follow(Block& block, const BlockText& text) {
  const auto offset = [this](const char* at) { return static_cast<std::size_t>(at - calls->data()); };
  const std::optional<TextPlace> next = calls->next(block, {offset(text.begin), text.line}, {offset(position), line});
  done = !next;
  if (done) return;
  position = calls->data() + next->offset;
  end = calls->data() + calls->size();
  line = next->line;
}

bool Reader::State::next(Block& block) {
  while (!done) {
    BlockText text;
    const Fetched fetched = fetch(text);
    if (fetched == Fetched::nothing) break;
    const BlockParser::Head head = parser.parse_head(block, text);
    const char* const statement = head.statement == nullptr ? text.stop : head.statement;
    if (!calls && fetched == Fetched::block && may_call(statement)) [[unlikely]] {
      keep_text();
      continue;
    }
    const bool skipped = head.slash && setup.block_skip;
    bool given = !skipped;
    if (fetched == Fetched::too_long) {
      if (given) parser.refuse_long(block, statement);
      pass_long(text, statement);
      mark = 0;
      if (given) return true;
      continue;
    }
    if (given && head.statement != nullptr) given = parser.parse_statement(block, statement);
    if (skipped || parser.passed_over()) check_bytes(text, statement);
    position += text.stop - position;
    if (position != end) ++position;
    line += lines;
    mark = 0;
    if (given) {
      if (calls) [[unlikely]]
        follow(block, text);
      else
        done = parser.ended();
      return true;
    }
  }
  done = true;
  return false;
}

// Blocks of a program that calls something are put in their order one by one.
void Reader::State::usual_lines(LineColumns& to, std::size_t most) {
  to.size = 0;
  to.words = 0;
  to.code = LineColumns::kNoCode;
  to.line = line;
  if (done || !begun || calls) return;
  if (static_cast<std::size_t>(end - position) < kBufferSize / 2) refill();
  *end = 0;  // no line goes on there
  for (const char* at = position; to.size < most; ++to.size) {
    at = read_usual_line(at, to);
    if (at == nullptr) return;
    line_end[to.size] = position + (at - position);
  }
}

Reader::Reader(std::unique_ptr<ByteSource> source, const Setup& setup, ReaderOptions options)
    : state_(std::make_unique<State>(std::move(source), setup, std::move(options))) {}
Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

bool Reader::next(Block& block) {
  try {
    return state_->next(block);
  } catch (...) {
    state_->done = true;
    throw;
  }
}

void Reader::lines(LineColumns& to, std::size_t most) { state_->usual_lines(to, most); }

void Reader::pass_lines(std::size_t count) {
  state_->position = state_->line_end[count - 1];
  state_->line += count;
}

}  // namespace toolcomp::spec::klartext
