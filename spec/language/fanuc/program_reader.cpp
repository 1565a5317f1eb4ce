#include "spec/language/fanuc/program_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "spec/language/digits.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

constexpr std::size_t kBufferSize = 65536;
constexpr int kMaxProgramDigits = 15;  // one more raises PS0003
constexpr int kEnd = -1;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

// What a byte may be where an address can stand.
enum class Kind : std::uint8_t {
  blank,
  line_end,
  letter,
  number,
  sign,
  block_end,
  open,
  percent,
  slash,
  colon,
  other,
  substitute,
  bad
};

constexpr std::array<Kind, 256> kKinds = [] {
  std::array<Kind, 256> kinds{};
  kinds.fill(Kind::bad);
  for (unsigned c = 0x21; c < 0x7F; ++c) kinds[c] = Kind::other;
  for (unsigned c = 'A'; c <= 'Z'; ++c) kinds[c] = kinds[c - 'A' + 'a'] = Kind::letter;
  for (unsigned c = '0'; c <= '9'; ++c) kinds[c] = Kind::number;
  kinds['.'] = Kind::number;
  kinds['+'] = kinds['-'] = Kind::sign;
  kinds[' '] = kinds['\t'] = kinds['\r'] = Kind::blank;
  kinds['\n'] = Kind::line_end;
  kinds[';'] = Kind::block_end;
  kinds['('] = Kind::open;
  kinds['%'] = Kind::percent;
  kinds['/'] = Kind::slash;
  kinds[':'] = Kind::colon;
  kinds[0x1A] = Kind::substitute;
  return kinds;
}();

constexpr bool is_digit(int c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// What an address admits.
struct Address {
  bool known = false;
  bool sign = false;
  bool point = false;
};

std::array<Address, 256> addresses(const Axes& axes) {
  std::array<Address, 256> table{};
  const auto admit = [&table](std::string_view letters, Address address) {
    for (const char c : letters) table[static_cast<unsigned char>(c)] = address;
  };
  admit("NOMTDHL", {.known = true, .sign = false, .point = false});
  admit("G", {.known = true, .sign = false, .point = true});
  admit("FSPQRIJK", {.known = true, .sign = true, .point = true});
  admit(axes.letters(), {.known = true, .sign = true, .point = true});
  return table;
}

}  // namespace

struct ProgramReader::State {
  State(std::unique_ptr<ByteSource> bytes, const Axes& axes, ReaderOptions reader_options)
      : source(std::move(bytes)), options(std::move(reader_options)), address(addresses(axes)) {}

  // The next byte, or kEnd, without taking it.
  int peek() {
    if (position != end || refill()) [[likely]]
      return static_cast<unsigned char>(*position);
    return kEnd;
  }
  void take() { ++position; }
  bool refill();
  void skip_byte_order_mark();

  // Bytes taken so far.
  [[nodiscard]] std::uint64_t offset() const { return consumed + static_cast<std::uint64_t>(position - buffer.data()); }
  // Of the byte that peek() shows.
  [[nodiscard]] std::uint32_t column() const {
    constexpr std::uint64_t kLast = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(offset() - line_start + 1, kLast));
  }

  // One block, up to and with what ends it; false if it has no word but N and no alarm.
  bool read_block(Block& block);
  // These return whether all is well; after a fault the rest of the block is behind.
  bool read_word(Block& block, char letter);
  bool read_number(Block& block, const Address& admitted, std::uint32_t start, Decimal& value);
  // The usual number without a detour, [-]digits[.digits] of at most seven each; false, and nothing taken, where it is
  // or may be any other.
  bool read_usual(const Address& admitted, Decimal& value);
  bool read_slash(Block& block);
  bool raise(Block& block, std::uint32_t column, const char* number, const char* message);
  void skip_comment();
  void skip_block();
  void end_line();
  void end_percent();
  void end_file();
  [[noreturn]] void refuse(int byte);

  std::unique_ptr<ByteSource> source;
  ReaderOptions options;
  std::array<Address, 256> address;
  std::array<char, kBufferSize + 2 * kDigitsRead> buffer{};  // the byte at `end` is 0
  const char* position = buffer.data();
  const char* end = buffer.data();
  std::uint64_t consumed = 0;    // bytes before the buffer
  std::uint64_t line = 1;        // being read
  std::uint64_t line_start = 0;  // offset of its first byte
  bool started = false;          // something other than blanks, comments, line ends and % was read
  bool begun = false;            // the % that begins the program was read
  bool exhausted = false;        // the source has no more bytes
  bool done = false;             // no more blocks
};

bool ProgramReader::State::refill() {
  if (exhausted) return false;
  const bool first = consumed == 0 && end == buffer.data();
  consumed += static_cast<std::uint64_t>(end - buffer.data());
  position = end = buffer.data();
  end += source->read(buffer.data(), kBufferSize);
  exhausted = position == end;
  if (first) skip_byte_order_mark();
  buffer[static_cast<std::size_t>(end - buffer.data())] = 0;
  if (exhausted) return false;
  return position != end || refill();
}

void ProgramReader::State::skip_byte_order_mark() {
  const auto size = [this] { return static_cast<std::size_t>(end - buffer.data()); };
  for (std::size_t more = size(); more > 0 && size() < kByteOrderMark.size(); end += more)
    more = source->read(buffer.data() + size(), kBufferSize - size());
  if (std::string_view(buffer.data(), size()).starts_with(kByteOrderMark)) position += kByteOrderMark.size();
}

// Attaches the fault; the rest of the block is not read as words.
bool ProgramReader::State::raise(Block& block, std::uint32_t column, const char* number, const char* message) {
  block.alarm = ReadAlarm{number, column, message};
  started = true;
  skip_block();
  return false;
}

void ProgramReader::State::refuse(int byte) {
  done = true;
  constexpr std::string_view kHex = "0123456789ABCDEF";
  const auto value = static_cast<unsigned>(byte);
  const std::string name = {'0', 'x', kHex[value >> 4], kHex[value & 15]};
  throw InputError(options.file, line, column(),
                   value >= 0x80 ? "byte " + name + " outside a comment; a program is ASCII text"
                                 : "control character " + name + "; a program is ASCII text");
}

// A Ctrl-Z pads the end of files from old systems; elsewhere it is a control character like any other.
void ProgramReader::State::end_file() {
  const std::uint32_t first = column();
  while (peek() == 0x1A) take();
  if (peek() == kEnd) return;
  done = true;
  throw InputError(options.file, line, first, "Ctrl-Z (0x1A) before the end of the file");
}

void ProgramReader::State::end_line() {
  take();
  ++line;
  line_start = offset();
}

void ProgramReader::State::end_percent() {
  take();
  if (started || begun)
    done = true;
  else
    begun = true;
}

// Up to and with the ), or up to the end of the line.
void ProgramReader::State::skip_comment() {
  take();
  for (;;) {
    const int byte = peek();
    if (byte == kEnd || byte == '\n') return;
    if (byte == 0x1A) {
      end_file();
      return;
    }
    if (byte < 0x80 && kKinds[static_cast<std::size_t>(byte)] == Kind::bad) refuse(byte);
    take();
    if (byte == ')') return;
  }
}

// Up to what ends the block; only bytes and comments are looked at.
void ProgramReader::State::skip_block() {
  for (;;) {
    const int byte = peek();
    if (byte == kEnd) return;
    switch (kKinds[static_cast<std::size_t>(byte)]) {
      case Kind::line_end:
      case Kind::block_end:
        return;
      case Kind::open:
        skip_comment();
        break;
      case Kind::substitute:
        end_file();
        break;
      case Kind::bad:
        refuse(byte);
      default:
        take();
    }
  }
}

// At the / that begins a block: the switch number, and the whole block where blocks are to be skipped.
bool ProgramReader::State::read_slash(Block& block) {
  if (block.size != 0 || block.n) return raise(block, column(), "PS0004", "/ stands only at the head of a block");
  started = true;
  take();
  const int byte = peek();
  if (byte >= '1' && byte <= '9') take();
  if (options.block_skip) skip_block();
  return true;
}

// An address, whose letter peek() still shows, and its number.
bool ProgramReader::State::read_word(Block& block, char letter) {
  const std::uint32_t start = column();
  const Address& admitted = address[static_cast<unsigned char>(letter)];
  if (!admitted.known) return raise(block, start, "PS0009", "this letter is no address of this control");
  if (letter != 'N' && block.size == Block::kMaxWords)
    return raise(block, start, "TOO_MANY_WORDS", "more words in the block than can be read");
  started = true;
  take();
  Decimal value;
  if (!read_usual(admitted, value) && !read_number(block, admitted, start, value)) return false;
  if (letter == 'N')
    block.n = value.digits;
  else
    block.word[block.size++] = {letter, value, start};
  return true;
}

// What stands behind the address, which began at `start`.
bool ProgramReader::State::read_number(Block& block, const Address& admitted, std::uint32_t start, Decimal& value) {
  int byte = peek();
  while (byte == ' ' || byte == '\t' || byte == '\r') take(), byte = peek();
  value = {};
  if (byte == '-' || byte == '+') {
    if (!admitted.sign) return raise(block, column(), "PS0006", "this address takes no sign");
    value.negative = byte == '-';
    take();
    byte = peek();
    if (byte == '-' || byte == '+') return raise(block, column(), "PS0006", "a second sign");
  }
  int digits = 0;
  for (;; take(), byte = peek()) {
    if (is_digit(byte)) {
      if (++digits > kMaxProgramDigits) return raise(block, column(), "PS0003", "a number of more than 15 digits");
      value.digits = value.digits * 10 + static_cast<std::uint64_t>(byte - '0');
      value.decimals = static_cast<std::uint8_t>(value.decimals + (value.point ? 1 : 0));
    } else if (byte == '.') {
      if (value.point) return raise(block, column(), "PS0007", "a second decimal point");
      if (!admitted.point) return raise(block, column(), "PS0007", "this address takes no decimal point");
      value.point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return raise(block, start, "PS0005", "an address without a digit");
  if (byte == '-' && value.negative) return raise(block, column(), "PS0006", "a second minus");
  return true;
}

bool ProgramReader::State::read_usual(const Address& admitted, Decimal& value) {
  const char* at = position;
  value.negative = *at == '-';
  if (value.negative) ++at;
  const Digits before = digits_at(at);
  if (before.count > 7) return false;
  at += before.count;
  value.point = *at == '.';
  value.digits = before.number;
  unsigned count = before.count;
  if (value.point) {
    const Digits behind = digits_at(++at);
    if (behind.count > 7) return false;
    at += behind.count;
    value.digits = value.digits * kPowersOfTen[behind.count] + behind.number;
    value.decimals = static_cast<std::uint8_t>(behind.count);
    count += behind.count;
  }
  // A number that reaches the end of the buffer may go on behind it.
  if (count == 0 || at == end || *at == '.' || *at == '-' || (value.negative && !admitted.sign) ||
      (value.point && !admitted.point))
    return false;
  position = at;
  return true;
}

bool ProgramReader::State::read_block(Block& block) {
  block.line = line;
  block.n.reset();
  block.size = 0;
  block.alarm.reset();
  const auto content = [&block] { return block.size != 0 || block.alarm; };
  while (!done) {
    const int byte = peek();
    if (byte == kEnd) {
      done = true;
      break;
    }
    switch (kKinds[static_cast<std::size_t>(byte)]) {
      case Kind::blank:
        take();
        break;
      case Kind::letter:
        // And the words behind it, which stand a blank apart at most.
        while (read_word(block, upper(*position))) {
          if (*position == ' ') take();
          if (kKinds[static_cast<unsigned char>(*position)] != Kind::letter) break;
        }
        break;
      case Kind::colon:
        read_word(block, 'O');
        break;
      case Kind::line_end:
        end_line();
        return content();
      case Kind::block_end:
        take();
        return content();
      case Kind::open:
        skip_comment();
        break;
      case Kind::percent:
        end_percent();
        break;
      case Kind::slash:
        read_slash(block);
        break;
      case Kind::number:
        raise(block, column(), "PS0004", "a number where an address must stand");
        break;
      case Kind::sign:
        raise(block, column(), "PS0004", "a sign where an address must stand");
        break;
      case Kind::other:
        raise(block, column(), "PS0004", "this character is no address");
        break;
      case Kind::substitute:
        end_file();
        break;
      case Kind::bad:
        refuse(byte);
    }
  }
  return content();
}

ProgramReader::ProgramReader(std::unique_ptr<ByteSource> source, const Axes& axes, ReaderOptions options)
    : state_(std::make_unique<State>(std::move(source), axes, std::move(options))) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

bool ProgramReader::next(Block& block) {
  while (!state_->done)
    if (state_->read_block(block)) return true;
  return false;
}

}  // namespace toolcomp::spec
