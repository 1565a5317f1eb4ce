// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/line_text.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "fast/basis/print.h"

namespace toolcomp::fast {
namespace {

constexpr std::size_t kIntegerText = 20;
constexpr std::size_t kStep = 16;  // short texts are copied in one step

}  // namespace

// Writes up to kStep more characters than the text has.
inline char* LineText::write(char* to, const Text& text) {
  std::memcpy(to, text.bytes.data(), kStep);
  const std::size_t size = text.size();
  if (size > kStep) [[unlikely]]
    std::memcpy(to, text.bytes.data(), size);
  return to + size;
}

void LineText::set_texts(const LineMoves& moves) {
  const Event& event = moves.event;
  const bool rapid = event.type == spec::MoveType::rapid;
  columns_ = 0;
  Text* text = &head_;
  text->begin();
  for (const char c : {'G', '0', rapid ? '0' : '1'}) text->add(c);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (!event.axes.has(axis)) continue;
    text->add(' ');
    text->add(axes_.letter(axis));
    if ((moves.moving >> axis & 1U) == 0) {
      text->add(event.axes[axis]);
      continue;
    }
    Column& column = column_[columns_++];
    column.value = moves.sent[axis];
    text = &column.after;
    text->begin();
  }
  if (event.feed && !rapid) {
    text->add(' ');
    text->add('F');
    text->add(*event.feed);
  }
  text->add('\n');
}

std::size_t LineText::longest_line() const {
  std::size_t size = head_.size() + kIntegerText + kStep + 2;
  for (std::size_t i = 0; i < columns_; ++i) size += kNumberText + column_[i].after.size();
  return size;
}

char* LineText::write(char* to, const LineMoves& moves) const {
  struct Last {
    double value = 0;
    const char* begin = nullptr;  // its text in an earlier line
    std::size_t size = 0;
  };
  std::array<Last, spec::kMaxAxes> lasts{};
  for (std::size_t i = 0; i < moves.size; ++i) {
    if (const auto n = moves.number(i)) {
      *to++ = 'N';
      to = std::to_chars(to, to + kIntegerText, *n).ptr;
      *to++ = ' ';
    }
    to = write(to, head_);
    for (std::size_t k = 0; k < columns_; ++k) {
      const double value = column_[k].value[i];
      Last& last = lasts[k];
      if (value == last.value && last.begin != nullptr) {
        std::array<char, kNumberText> text;
        std::memcpy(text.data(), last.begin, kNumberText);
        std::memcpy(to, text.data(), kNumberText);
      } else {
        last.value = value;
        last.size = static_cast<std::size_t>(write_number(to, value) - to);
      }
      last.begin = to;
      to = write(to + last.size, column_[k].after);
    }
  }
  return to;
}

void LineText::append(spec::TextBuffer& out, LineMoves& moves, spec::GcodeState<double>& state) {
  set_texts(moves);
  spec::TextCursor(out, moves.size * longest_line() + kNumberText).write([&](char* to) { return write(to, moves); });
  const Event& last = moves.at(moves.size - 1);
  for (std::size_t axis = 0; axis < axes_.size(); ++axis)
    if (last.point.has(axis)) state.point.set(axis, last.point[axis]);
}

}  // namespace toolcomp::fast
