// Lemmas about whole programs of the tool length offset.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "corpus/proofs/fanuc/program.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

enum class Mode : std::uint8_t { cancelled, add, subtract };

// Translates a program, block by block, into commands of ToolLengthOffset.v.
class Translator {
 public:
  explicit Translator(const spec::Setup& setup) : setup_(setup) {}

  // The commands of a block, or nothing if it has words beyond the formal specification.
  std::optional<std::vector<std::string>> block(const spec::Block& block) {
    commands_.clear();
    for (const spec::Word& w : block.words())
      if (!take(w)) return std::nullopt;
    const bool code = has(block, "G43") || has(block, "G44");
    if (has(block, "G43")) mode_ = Mode::add;
    if (has(block, "G44")) mode_ = Mode::subtract;
    if (code && has(block, "G43") == has(block, "G44")) return std::nullopt;
    const auto h = word(block, 'H');
    if (h) number_ = h->digits;
    if (has(block, "G49")) {
      if (code || h) return std::nullopt;  // both in one block: not the formal specification's concern
      mode_ = Mode::cancelled;
      if (setup_.g49_sets_h0) number_ = 0;
      commands_.emplace_back("CancelAll");
    } else if (code || (h && mode_ != Mode::cancelled)) {
      commands_.push_back(fmt::format("Offset {} {} {}", mode_ == Mode::add ? "G43" : "G44", axis(),
                                      coq(offset_of(setup_, 'H', number_))));
    }
    for (const spec::Word& w : block.words())
      if (w.address >= 'X')
        commands_.push_back(
            fmt::format("{} {} {}", incremental_ ? "Incremental" : "Absolute", w.address, coq(w.value)));
    return commands_;
  }

 private:
  bool take(const spec::Word& w) {
    switch (w.address) {
      case 'X':
      case 'Y':
      case 'Z':
      case 'F':
      case 'H':
        return true;
      case 'G':
        return code(value_of(w.value));
      default:
        return false;
    }
  }

  bool code(const Rational& g) {
    if (g == 90 || g == 91) incremental_ = g == 91;
    if (g == 17 || g == 18 || g == 19) plane_ = static_cast<int>(numerator(g));
    constexpr std::array kKnown{0, 1, 17, 18, 19, 43, 44, 49, 90, 91};
    return std::ranges::any_of(kKnown, [&](int known) { return g == known; });
  }

  // Type A: Z. Type B: the axis at right angles to the plane.
  [[nodiscard]] char axis() const {
    if (!setup_.bit(5001, 1)) return 'Z';
    return plane_ == 17 ? 'Z' : plane_ == 18 ? 'Y' : 'X';
  }

  const spec::Setup& setup_;
  std::vector<std::string> commands_;
  Mode mode_ = Mode::cancelled;
  std::uint64_t number_ = 0;
  int plane_ = 17;
  bool incremental_ = false;
};

std::string start(const spec::Setup& setup) {
  std::string text = "at_rest";
  for (const char letter : {'X', 'Y', 'Z'}) {
    const auto found = setup.position.find(letter);
    text += ' ' + (found == setup.position.end() ? "0" : coq(found->second));
  }
  return text;
}

// "(x, y, z)" of what the axes are sent to.
std::optional<std::string> position(const spec::Case& c, const spec::TextEvent& event) {
  std::string text;
  for (const char letter : {'X', 'Y', 'Z'}) {
    const auto value = fraction_of(event.axes[c.setup.axes.index(letter)]);
    if (!value) return std::nullopt;
    text += (text.empty() ? "(" : ", ") + coq(*value);
  }
  return text + ')';
}

}  // namespace

// Types A and B with OFH = 0 and no more words than X Y Z F H and G00 G01 G17 G18 G19 G43 G44 G49 G90 G91.
std::vector<Lemma> length_offset_lemmas(const spec::Case& c) {
  const auto blocks = blocks_of(c);
  const auto is_move = [](const spec::TextEvent& event) { return event.kind == spec::EventKind::move; };
  const bool xyz = c.setup.axes.has('X') && c.setup.axes.has('Y') && c.setup.axes.has('Z');
  if (!blocks || !xyz || c.setup.bit(5001, 0) || c.setup.bit(5001, 2) || c.expect.empty() ||
      !std::ranges::all_of(c.expect, is_move))
    return {};
  Translator translator(c.setup);
  std::string groups;
  std::string positions;
  std::vector<std::string> group;
  std::size_t event = 0;
  for (const auto& [line, block] : *blocks) {
    if (has(block, "M02") || has(block, "M30")) break;
    if (has(block, "G04") && block.size == 2 && word(block, 'P')) continue;  // a dwell
    const auto commands = translator.block(block);
    if (!commands) return {};
    group.insert(group.end(), commands->begin(), commands->end());
    if (event >= c.expect.size() || c.expect[event].line != line) continue;
    const auto place = position(c, c.expect[event++]);
    if (!place) return {};
    groups += fmt::format("{}[{}]", groups.empty() ? "" : ";\n     ", fmt::join(group, "; "));
    positions += (positions.empty() ? "" : ";\n     ") + *place;
    group.clear();
  }
  if (event != c.expect.size()) return {};
  Lemma lemma;
  lemma.name = identifier(c.id);
  lemma.text = fmt::format("Lemma {} :\n  targets ({})\n    [{}] =\n    [{}].\nProof. by_sums. Qed.\n", lemma.name,
                           start(c.setup), groups, positions);
  return {std::move(lemma)};
}

}  // namespace toolcomp::corpus
