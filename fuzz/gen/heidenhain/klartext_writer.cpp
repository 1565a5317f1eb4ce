// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/klartext_writer.h"

#include <fmt/format.h>

namespace toolcomp::fuzz {

std::string klartext_number(Choices& choose, std::int64_t count, int decimals) {
  std::int64_t one = 1;
  for (int i = 0; i < decimals; ++i) one *= 10;
  const std::int64_t magnitude = count < 0 ? -count : count;
  std::string text;
  if (count < 0) {
    constexpr int minus[] = {94, 3, 3};
    constexpr std::string_view signs[] = {"-", "\u2212", "\u2013"};
    text = signs[choose.weighted(minus)];
  } else if (choose.chance(75)) {
    text = count == 0 && choose.chance(5) ? "-" : "+";
  }
  const std::int64_t whole = magnitude / one;
  std::string fraction = decimals > 0 ? fmt::format("{:0{}}", magnitude % one, decimals) : std::string();
  if (choose.chance(70)) fraction.erase(fraction.find_last_not_of('0') + 1);
  if (whole != 0 || fraction.empty() || !choose.chance(6)) text += std::to_string(whole);
  if (!fraction.empty()) text += (choose.chance(6) ? "," : ".") + fraction;
  return text;
}

KlartextWriter::KlartextWriter(Choices& choose)
    : choose_(choose), numbered_(choose.chance(60)), lower_case_(choose.chance(3)) {}

KlartextWriter& KlartextWriter::word(std::string_view text) {
  if (text.empty()) return *this;
  if (!block_.empty()) block_ += ' ';
  block_ += text;
  return *this;
}

KlartextWriter& KlartextWriter::number(std::string_view key, std::int64_t count, int decimals) {
  const std::string text = klartext_number(choose_, count, decimals);
  return word(std::string(key) + text);
}

KlartextWriter& KlartextWriter::value(std::string_view key, std::int64_t count, int decimals,
                                      std::uint64_t by_parameter) {
  if (!choose_.chance(by_parameter)) return number(key, count, decimals);
  constexpr std::string_view kinds[] = {"Q", "QL", "QR"};
  const std::string_view kind = choose_.one_of(kinds);
  const std::int64_t index = choose_.between(0, 9);
  const std::string parameter = fmt::format("{}{}", kind, index);
  const bool negated = choose_.chance(25);
  // Without a value it is 0.
  if (!choose_.chance(4)) {
    const std::string text = klartext_number(choose_, negated ? -count : count, decimals);
    const bool function = kind == "Q" && choose_.chance(40);
    before_ += fmt::format("{}{} = {}\n", function ? "FN 0: " : "", parameter, text);
  }
  const std::string_view sign = negated ? "-" : choose_.chance(60) ? "+" : "";
  return word(fmt::format("{}{}{}", key, sign, parameter));
}

void KlartextWriter::put(std::string block, bool may_go_on) {
  const bool skipped = choose_.chance(1);
  const bool before = choose_.chance(50);
  if (skipped && before) text_ += "/ ";
  if (numbered_ && choose_.chance(97)) text_ += fmt::format("{} ", n_);
  if (skipped && !before) text_ += "/";
  ++n_;
  if (may_go_on && choose_.chance(2)) {
    const std::size_t blank = block.find(' ', block.size() / 2);
    if (blank != std::string::npos && blank > 0) block.replace(blank, 1, " ~\n  ");
  }
  bool quoted = false;
  if (lower_case_)
    for (char& c : block) {
      if (c == '"') quoted = !quoted;
      if (!quoted && c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
  text_ += block;
  if (choose_.chance(3)) text_ += " ; remark";
  text_ += '\n';
}

void KlartextWriter::end_block(bool may_go_on) {
  if (block_.empty()) return;
  while (!before_.empty()) {
    const std::size_t end = before_.find('\n');
    put(before_.substr(0, end), false);
    before_.erase(0, end + 1);
  }
  put(std::move(block_), may_go_on);
  block_.clear();
}

void KlartextWriter::remark() {
  constexpr std::string_view lines[] = {"; finishing", "* - face", ";", "  ", "; Fl\u00e4che \u00d820"};
  text_ += choose_.one_of(lines);
  text_ += '\n';
}

}  // namespace toolcomp::fuzz
