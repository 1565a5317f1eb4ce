// SPDX-License-Identifier: Apache-2.0
// Text of a manual page: macros of mdoc, and text in which nothing is taken for one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::cli::roff {

// Running text: backslashes, points at the head of a line and characters beyond ASCII escaped; hyphens of options kept
// as they are typed.
std::string running(std::string_view text);
// A word behind a macro.
std::string word(const std::string& text);
// The first letter in lower case, unless the second is a capital too (JSON).
std::string lowered(std::string text);

class Page {
 public:
  // `date` as "January 31, 2026".
  Page(const std::string& title, int section, const std::string& date);

  void section(std::string_view title);
  // A line of macros, as it is.
  void line(const std::string& macros);
  // Sentences, each on a line of its own.
  void text(std::string_view sentences);
  void paragraphs(const std::vector<std::string_view>& texts);
  // A line of a display.
  void literal(std::string_view text);
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace toolcomp::cli::roff
