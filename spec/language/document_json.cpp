// SPDX-License-Identifier: Apache-2.0
// A JSON parser that keeps what the readers need and DOM libraries drop: the text of every number (-0, 1.50), the
// position of every value, names given twice, and a bound on nesting.
#include <algorithm>
#include <utility>

#include "spec/language/document.h"
#include "spec/language/input_error.h"
#include "spec/language/json_text.h"

namespace toolcomp::spec::document {
namespace {

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Node document() {
    Node root = value(0);
    blanks();
    if (at_ != text_.size()) fail("unexpected text after the end of the JSON value");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, line_, at_ - line_start_ + 1, message);
  }
  [[nodiscard]] Position position() const { return {line_, at_ - line_start_ + 1}; }
  [[nodiscard]] int peek() const { return at_ < text_.size() ? static_cast<unsigned char>(text_[at_]) : -1; }
  [[nodiscard]] bool digit() const { return peek() >= '0' && peek() <= '9'; }

  void blanks() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        return;
      }
    }
  }

  void require(char c, const char* message) {
    if (peek() != c) fail(message);
    ++at_;
  }

  Node value(int depth) {
    if (depth > kMaxDepth) fail("nested too deep");
    if (++values_ > kMaxValues) fail("more than " + std::to_string(kMaxValues) + " values");
    blanks();
    Node node;
    node.at = position();
    switch (peek()) {
      case '{':
        table(node, depth);
        break;
      case '[':
        array(node, depth);
        break;
      case '"':
        node.kind = Kind::string;
        node.text = string();
        break;
      case 't':
        literal("true");
        node.kind = Kind::boolean;
        node.boolean = true;
        break;
      case 'f':
        literal("false");
        node.kind = Kind::boolean;
        break;
      case 'n':
        literal("null");
        break;
      default:
        node.kind = Kind::number;
        node.text = number();
    }
    return node;
  }

  void literal(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) fail("expected a JSON value");
    at_ += word.size();
  }

  std::string number() {
    const std::size_t first = at_;
    if (peek() == '-') ++at_;
    if (!digit()) fail(at_ == first ? "expected a JSON value" : "a number without digits");
    if (peek() == '0')
      ++at_;
    else
      digits();
    if (digit()) fail("a JSON number must not begin with 0 and another digit");
    if (peek() == '.') {
      ++at_;
      digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      digits();
    }
    return std::string(text_.substr(first, at_ - first));
  }

  void digits() {
    if (!digit()) fail("expected a digit");
    while (digit()) ++at_;
  }

  void array(Node& node, int depth) {
    node.kind = Kind::array;
    ++at_;
    blanks();
    if (peek() == ']') {
      ++at_;
      return;
    }
    for (;;) {
      node.items.push_back(value(depth + 1));
      blanks();
      if (peek() == ']') break;
      require(',', "expected , or ] in an array");
    }
    ++at_;
  }

  void table(Node& node, int depth) {
    node.kind = Kind::table;
    ++at_;
    blanks();
    if (peek() == '}') {
      ++at_;
      return;
    }
    for (;;) {
      blanks();
      Member member;
      member.at = position();
      if (peek() != '"') fail("expected a name in double quotes");
      member.name = string();
      blanks();
      require(':', "expected : after a name");
      member.value = value(depth + 1);
      node.members.push_back(std::move(member));
      blanks();
      if (peek() == '}') break;
      require(',', "expected , or } in an object");
    }
    ++at_;
    refuse_doubles(node);
  }

  // By sorting, so that an object of many names costs no more than reading it.
  void refuse_doubles(const Node& node) const {
    std::vector<const Member*> sorted;
    sorted.reserve(node.members.size());
    for (const Member& member : node.members) sorted.push_back(&member);
    std::ranges::sort(sorted, {}, [](const Member* m) { return std::pair(std::string_view(m->name), m); });
    const auto twice =
        std::ranges::adjacent_find(sorted, {}, [](const Member* m) { return std::string_view(m->name); });
    if (twice == sorted.end()) return;
    const Member& second = **std::next(twice);
    throw InputError(file_, second.at.line, second.at.column, in_quotes(second.name) + " is given twice");
  }

  std::string string() {
    ++at_;
    std::string out;
    for (;;) {
      const std::size_t plain = at_;
      while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\\' && peek() >= 0x20 && peek() < 0x80) ++at_;
      out.append(text_, plain, at_ - plain);
      const int byte = peek();
      if (byte == '"') break;
      if (byte == -1) fail("a string without its closing quote");
      if (byte < 0x20) fail("a control character in a string; expected an escape such as \\n");
      if (byte == '\\')
        escape(out);
      else
        utf8(out);
    }
    ++at_;
    return out;
  }

  void escape(std::string& out) {
    ++at_;
    constexpr std::string_view kNames = "\"\\/bfnrt";
    constexpr std::string_view kBytes = "\"\\/\b\f\n\r\t";
    const int name = peek();
    if (name == 'u') {
      unicode(out);
      return;
    }
    const std::size_t index = name < 0 ? std::string_view::npos : kNames.find(static_cast<char>(name));
    if (index == std::string_view::npos) fail("an unknown escape in a string");
    out += kBytes[index];
    ++at_;
  }

  unsigned hex4() {
    ++at_;  // the u
    unsigned code = 0;
    for (int i = 0; i < 4; ++i, ++at_) {
      const int c = peek();
      if (c >= '0' && c <= '9')
        code = code * 16 + static_cast<unsigned>(c - '0');
      else if ((c | 0x20) >= 'a' && (c | 0x20) <= 'f')
        code = code * 16 + static_cast<unsigned>((c | 0x20) - 'a' + 10);
      else
        fail("expected four hexadecimal digits after \\u");
    }
    return code;
  }

  void unicode(std::string& out) {
    unsigned code = hex4();
    if (code >= 0xDC00 && code <= 0xDFFF) fail("the second half of a surrogate pair without the first");
    if (code >= 0xD800 && code <= 0xDBFF) {
      if (text_.substr(at_, 2) != "\\u") fail("the first half of a surrogate pair without the second");
      ++at_;
      const unsigned low = hex4();
      if (low < 0xDC00 || low > 0xDFFF) fail("the first half of a surrogate pair without the second");
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    const auto tail = [&out](unsigned bits) { out += static_cast<char>(0x80 | (bits & 0x3F)); };
    if (code < 0x80) {
      out += static_cast<char>(code);
    } else if (code < 0x800) {
      out += static_cast<char>(0xC0 | code >> 6);
      tail(code);
    } else if (code < 0x10000) {
      out += static_cast<char>(0xE0 | code >> 12);
      tail(code >> 6);
      tail(code);
    } else {
      out += static_cast<char>(0xF0 | code >> 18);
      tail(code >> 12);
      tail(code >> 6);
      tail(code);
    }
  }

  void utf8(std::string& out) {
    const std::size_t length = utf8_length(text_.substr(at_));
    if (length == 0) fail("a string that is not UTF-8");
    out.append(text_, at_, length);
    at_ += length;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
  std::size_t line_start_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

Node parse_json(std::string_view text, const std::string& file) { return Parser(text, file).document(); }

}  // namespace toolcomp::spec::document
