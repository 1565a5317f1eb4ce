// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/heidenhain/klartext_program.h"

#include <algorithm>
#include <array>
#include <memory>

#include "judge/laws/numbers.h"
#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge::laws {
namespace {

using spec::klartext::Block;
using spec::klartext::CorrectionTable;
using spec::klartext::ParameterKind;
using spec::klartext::RadiusWord;
using spec::klartext::ReferenceWord;
using spec::klartext::Statement;
using spec::klartext::ToolWord;
using spec::klartext::Value;

struct Deltas {
  Rational l, r, r2;
};

// The deltas a tool call writes; a parameter makes them unknown.
bool read(const std::optional<Value>& word, Rational& into) {
  if (!word) return true;
  if (word->parameter.kind != ParameterKind::none) return false;
  into = rational(word->number);
  return true;
}

Vector vector(const std::array<spec::Decimal, 3>& words) {
  return {Real(rational(words[0])), Real(rational(words[1])), Real(rational(words[2]))};
}

class State {
 public:
  explicit State(const spec::Setup& setup) : setup_(setup), inch_(setup.units == spec::Units::inch) {
    state_.rotary = std::make_shared<const std::array<Rational, 3>>();
  }

  KlartextBlock read_block(const Block& b) {
    // Members that a statement does not have keep what they held.
    const bool moves = b.statement == Statement::line || b.statement == Statement::line_with_vectors;
    const bool has_functions = moves || b.statement == Statement::stop || b.statement == Statement::miscellaneous;
    bool ends_tcpm = false;
    for (std::size_t i = 0; has_functions && i < b.functions; ++i) {
      if (b.function.at(i) == 128) {
        state_.tcpm = true;
        state_.center = setup_.m128_reference == spec::M128Reference::center;
      }
      ends_tcpm = ends_tcpm || b.function.at(i) == 129;
    }
    switch (b.statement) {
      case Statement::begin_program:
        inch_ = b.unit == spec::Units::inch;
        stale_ = true;
        break;
      case Statement::tool_call:
        call(b);
        break;
      case Statement::tcpm:
        state_.tcpm = true;
        state_.center = b.reference == ReferenceWord::center_center;
        break;
      case Statement::reset_tcpm:
        state_.tcpm = false;
        break;
      case Statement::programmed_path:
        state_.contour = b.contour;
        break;
      case Statement::call_program:
        state_.side = 0;
        break;
      case Statement::correction_row:
        if (b.corrections != CorrectionTable::wpl) row_ = b.row;
        stale_ = true;
        break;
      case Statement::reset_corrections:
        if (b.corrections != CorrectionTable::wpl) row_.reset();
        stale_ = true;
        break;
      default:
        break;
    }
    if (moves && b.radius != RadiusWord::none)
      state_.side = b.radius == RadiusWord::rl ? 1 : b.radius == RadiusWord::rr ? -1 : 0;
    state_.line = b.line;
    state_.statement = b.statement;
    state_.drills = b.calls_cycle;
    state_.normal.reset();
    state_.tool.reset();
    if (b.statement == Statement::line_with_vectors) {
      if (b.has_normal) state_.normal = vector(b.normal);
      if (b.has_tool_vector) state_.tool = vector(b.tool_vector);
    }
    turn(b);
    if (stale_) state_.cutter = cutter();
    stale_ = false;
    const KlartextBlock now = state_;
    if (ends_tcpm) state_.tcpm = false;
    return now;
  }

 private:
  void call(const Block& b) {
    stale_ = true;
    if (b.tool_axis != 0) {
      if (state_.tcpm && b.tool_axis != state_.axis) state_.rotary = nullptr;
      state_.axis = b.tool_axis;
    }
    if (b.tool != ToolWord::none) {
      tool_ = nullptr;
      for (const spec::ToolRow& row : setup_.tools)
        if (b.tool == ToolWord::number
                ? row.number == b.tool_number
                : b.tool == ToolWord::name && !row.name.empty() && row.name == b.tool_name.view())
          tool_ = &row;
      called_ = {};
      known_ = true;
      row_.reset();
      state_.side = 0;
    }
    known_ = read(b.dl, called_.l) && known_;
    known_ = read(b.dr, called_.r) && known_;
    known_ = read(b.dr2, called_.r2) && known_;
  }

  void turn(const Block& b) {
    if (!state_.rotary) return;
    if (b.statement == Statement::line_with_vectors && state_.tcpm) {
      state_.rotary = nullptr;
      return;
    }
    constexpr std::size_t first = spec::klartext::kAxisLetters.find('A');
    constexpr unsigned slots = 0b111U << first;
    const bool moves = b.statement == Statement::line;
    if ((!moves && b.statement != Statement::cycle) || (b.axes & slots) == 0) return;
    auto at = std::make_shared<std::array<Rational, 3>>(*state_.rotary);
    bool known = moves;
    for (std::size_t i = 0; i < at->size(); ++i) {
      if (!b.has_axis(first + i)) continue;
      const Value& word = b.axis.at(first + i);
      known = known && word.parameter.kind == ParameterKind::none;
      if (known) at->at(i) = rational(word.number) + (b.is_incremental(first + i) ? at->at(i) : Rational(0));
    }
    state_.rotary = known ? at : nullptr;
  }

  [[nodiscard]] std::shared_ptr<const Cutter> cutter() const {
    if (tool_ == nullptr || !known_ || tool_->number == 0) return nullptr;
    // Tables are in millimetres.
    const Rational unit = inch_ ? Rational(5, 127) : Rational(1);
    spec::CorrectionRow row;
    if (row_) {
      const auto found = setup_.tcs.find(*row_);
      if (found == setup_.tcs.end()) return nullptr;
      row = found->second;
    }
    const Rational r = rational(tool_->r) * unit;
    const Rational r2 = rational(tool_->r2) * unit;
    const Rational dr = (rational(tool_->dr) + rational(row.dr)) * unit + called_.r;
    const Rational dr2 = (rational(tool_->dr2) + rational(row.dr2)) * unit + called_.r2;
    Cutter c;
    c.r = r;
    c.r2 = r2;
    c.dl = Rational((rational(tool_->dl) + rational(row.dl)) * unit + called_.l);
    c.dr = dr;
    c.dr2 = dr2;
    c.ring = Rational(r - r2);
    c.effective_r2 = Rational(r2 + dr2);
    c.effective_ring = std::max(Rational(0), Rational(r + dr - r2 - dr2));
    if (tool_->l) c.length = Real(Rational(rational(*tool_->l) * unit));
    c.by_angle = !tool_->dr2_table.empty();
    return std::make_shared<const Cutter>(c);
  }

  const spec::Setup& setup_;
  KlartextBlock state_;
  const spec::ToolRow* tool_ = nullptr;
  Deltas called_;
  bool known_ = true;
  bool inch_;
  bool stale_ = true;  // the cutter is another than the state says
  std::optional<std::uint32_t> row_;
};

}  // namespace

KlartextProgram::KlartextProgram(const spec::Case& c) {
  if (c.setup.control != spec::Control::heidenhain) return;
  State state(c.setup);
  try {
    spec::klartext::Reader reader(spec::text_source(c.program), c.setup, {.file = "program"});
    const auto block = std::make_unique<Block>();
    while (reader.next(*block) && !block->alarm) {
      // Where calls or repeats lead back, a line has no one state: nothing is known of such a program.
      if (!blocks_.empty() && block->line <= blocks_.back().line) {
        blocks_.clear();
        return;
      }
      blocks_.push_back(state.read_block(*block));
    }
  } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch): the run says so, where it comes so far
  }
}

const KlartextBlock* KlartextProgram::block(std::uint64_t line) const {
  const auto found = std::ranges::lower_bound(blocks_, line, {}, &KlartextBlock::line);
  return found != blocks_.end() && found->line == line ? &*found : nullptr;
}

bool KlartextProgram::calls_tool(std::uint64_t from, std::uint64_t to) const {
  return std::ranges::any_of(blocks_, [&](const KlartextBlock& b) {
    return b.line > from && b.line <= to && b.statement == Statement::tool_call;
  });
}

}  // namespace toolcomp::judge::laws
