#include "corpus/proofs/heidenhain/space.h"

#include <fmt/format.h>

#include <algorithm>

#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

using spec::klartext::Block;
using spec::klartext::RadiusWord;
using spec::klartext::Statement;

constexpr std::size_t kLinear = 3;  // X Y Z, then the rotary axes
constexpr std::size_t kLastRotary = 6;

Exact3 exact(const std::array<spec::Decimal, 3>& v) { return {value_of(v[0]), value_of(v[1]), value_of(v[2])}; }

bool is_parameter(const spec::klartext::Value& value) {
  return value.parameter.kind != spec::klartext::ParameterKind::none;
}
bool is_parameter(const std::optional<spec::klartext::Value>& value) { return value && is_parameter(*value); }

// Goes through a program block by block.
class Program {
 public:
  explicit Program(const spec::Case& c) : case_(c) { upright(); }

  std::optional<std::vector<SpaceMove>> moves() {
    if (case_.setup.units != spec::Units::mm) return std::nullopt;
    try {
      spec::klartext::Reader reader(spec::text_source(case_.program), case_.setup);
      for (Block block; reader.next(block);)
        if (!take(block)) return std::nullopt;
    } catch (const spec::InputError&) {
      return std::nullopt;  // behind the end of the run, as the vector has one
    }
    return std::move(moves_);
  }

 private:
  // False for what is not covered.
  bool take(const Block& block) {
    if (block.alarm) return false;
    switch (block.statement) {
      case Statement::begin_program:
        return block.unit == spec::Units::mm;
      case Statement::tool_call:
        return call(block);
      case Statement::tcpm:
        state_.tcpm = true;
        state_.center = block.reference == spec::klartext::ReferenceWord::center_center;
        return true;
      case Statement::reset_tcpm:
        return stop_tcpm();
      case Statement::programmed_path:
        state_.contour = block.contour;
        return true;
      case Statement::correction_row:
        if (block.corrections == spec::klartext::CorrectionTable::tcs) row_ = case_.setup.tcs.at(block.row);
        return true;
      case Statement::reset_corrections:
        if (block.corrections != spec::klartext::CorrectionTable::wpl) row_ = {};
        return true;
      case Statement::assignment:
        return false;
      case Statement::cycle:
        return block.axes == 0;
      case Statement::line:
      case Statement::line_with_vectors:
        return line(block);
      case Statement::stop:
      case Statement::miscellaneous:
        start(block);
        return end(block);
      default:
        return true;
    }
  }

  bool call(const Block& block) {
    if (is_parameter(block.dl) || is_parameter(block.dr) || is_parameter(block.dr2)) return false;
    const bool with_tool = block.tool != spec::klartext::ToolWord::none;
    if (with_tool) {
      call_ = {};
      row_ = {};
      state_.side = 0;
      tool_ = {};
      const auto found = std::ranges::find_if(case_.setup.tools, [&](const spec::ToolRow& row) {
        return block.tool == spec::klartext::ToolWord::name ? row.name == block.tool_name.view()
                                                            : row.number == block.tool_number;
      });
      if (found != case_.setup.tools.end()) tool_ = *found;
    }
    if (block.dl) call_.dl = block.dl->number;
    if (block.dr) call_.dr = block.dr->number;
    if (block.dr2) call_.dr2 = block.dr2->number;
    if (block.tool_axis != 0) axis_ = static_cast<std::size_t>(block.tool_axis - 'X');
    if (!state_.tcpm) upright();
    return true;
  }

  void upright() {
    Exact3 along{};
    along.at(axis_) = 1;
    state_.tool = along;
  }

  bool stop_tcpm() {
    state_.tcpm = false;
    upright();
    return true;
  }

  static bool calls(const Block& block, std::uint16_t function) {
    return std::ranges::find(block.function.begin(), block.function.begin() + block.functions, function) !=
           block.function.begin() + block.functions;
  }
  void start(const Block& block) {
    if (!calls(block, 128)) return;
    state_.tcpm = true;
    state_.center = false;
  }
  bool end(const Block& block) {
    if (calls(block, 129)) stop_tcpm();
    return true;
  }

  bool line(const Block& block) {
    start(block);
    if (block.radius != RadiusWord::none)
      state_.side = block.radius == RadiusWord::rl ? 1 : block.radius == RadiusWord::rr ? -1 : 0;
    const bool vectors = block.statement == Statement::line_with_vectors;
    if (vectors || block.axes != 0) {
      for (std::size_t i = 0; i < spec::klartext::kAxisLetters.size(); ++i)
        if (block.has_axis(i) && is_parameter(block.axis.at(i))) return false;
      state_.normal.reset();
      if (vectors && block.has_normal) state_.normal = exact(block.normal);
      if (state_.tcpm) turn(block);
      if (!move(block)) return false;
    }
    return end(block);
  }

  void turn(const Block& block) {
    if (block.statement == Statement::line_with_vectors) {
      state_.tool = block.has_tool_vector ? exact(block.tool_vector) : state_.normal;
      return;
    }
    for (std::size_t i = kLinear; i < kLastRotary; ++i)
      if (block.has_axis(i)) state_.tool.reset();
  }

  bool move(const Block& block) {
    const auto event = std::ranges::find_if(case_.expect, [&](const spec::TextEvent& e) {
      return e.kind == spec::EventKind::move && e.line == block.line;
    });
    if (event == case_.expect.end()) return false;
    SpaceMove move = state_;
    move.event = &*event;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = fraction_of(event->programmed[case_.setup.axes.index("XYZ"[i])]);
      if (!value) return false;
      move.programmed.at(i) = *value;
    }
    move.center = move.center && move.tcpm;
    move.has_table = !tool_.dr2_table.empty();
    move.radius = value_of(tool_.r);
    move.corner = value_of(tool_.r2);
    move.dl = value_of(tool_.dl) + value_of(call_.dl) + value_of(row_.dl);
    move.dr = value_of(tool_.dr) + value_of(call_.dr) + value_of(row_.dr);
    move.dr2 = value_of(tool_.dr2) + value_of(call_.dr2) + value_of(row_.dr2);
    moves_.push_back(std::move(move));
    return true;
  }

  const spec::Case& case_;
  std::vector<SpaceMove> moves_;
  SpaceMove state_;
  std::size_t axis_ = 2;
  spec::ToolRow tool_;
  spec::CorrectionRow call_, row_;
};

// |v|, where it is rational; 0 for the zero vector.
std::optional<Rational> length(const Exact3& v) { return square_root(dot(v, v)); }

Exact3 scaled(const Rational& k, const Exact3& v) { return {k * v[0], k * v[1], k * v[2]}; }

// The direction of compensation of a movement, as Coq writes it, and the length of its cross product.
struct Side {
  std::string text;
  std::optional<Rational> root;
};
std::optional<Side> side_of(const Exact3& tool, const Exact3& from, const Exact3& to, int side) {
  const Exact3 movement = difference(to, from);
  const Exact3 product = cross(tool, movement);
  if (product == Exact3{}) return std::nullopt;
  return Side{fmt::format("(PeripheralMilling.c ({}) {} {})", side, coq(tool), coq(movement)), length(product)};
}

}  // namespace

std::optional<std::vector<SpaceMove>> space_moves(const spec::Case& c) { return Program(c).moves(); }

std::string tool_text(const SpaceMove& move) {
  return fmt::format("(FaceMilling.Tool {} {})", coq(move.radius), coq(move.corner));
}

std::string deltas_text(const SpaceMove& move) {
  return fmt::format("(FaceMilling.Deltas {} {} {})", coq(move.dl), coq(move.dr), coq(move.dr2));
}

std::string reference_text(const SpaceMove& move) { return move.center ? "FaceMilling.CNT" : "FaceMilling.TIP"; }

Lemma recorded_point(const spec::Case& c, const SpaceMove& move, const std::string& value,
                     const std::optional<std::string>& computed) {
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), move.event->line);
  lemma.by_intervals = !computed;
  std::string statement;
  for (std::size_t i = 0; i < 3; ++i) {
    const spec::NumberText& number = move.event->point[c.setup.axes.index("XYZ"[i])];
    const auto exactly = fraction_of(number);
    statement += i == 0 ? "\n    " : " /\\\n    ";
    statement += exactly
                     ? fmt::format("v{} p = {}", "xyz"[i], coq(*exactly))
                     : fmt::format("recorded (v{} p) {} {}", "xyz"[i], coq_decimal(number.v), coq_decimal(number.r));
  }
  lemma.text = fmt::format("Lemma {} : let p := {} in{}.\nProof. {}. Qed.\n", lemma.name, value, statement,
                           computed.value_or("space_by_intervals"));
  return lemma;
}

Lemma contact_lemma(const spec::Case& c, const SpaceMove& move) {
  const std::string vectors = coq(*move.normal) + ' ' + coq(*move.tool);
  const std::string point = coq(move.programmed);
  const std::string value = move.contour
                                ? fmt::format("ProgrammedContour.contour_tip {} {} {}\n      {}", tool_text(move),
                                              deltas_text(move), point, vectors)
                                : fmt::format("FaceMilling.effective_tip {} {} {}\n      {} {}", reference_text(move),
                                              tool_text(move), deltas_text(move), point, vectors);
  const Exact3& normal = *move.normal;
  const Exact3& tool = *move.tool;
  const Exact3 across = difference(scaled(dot(tool, tool), normal), scaled(dot(normal, tool), tool));
  const auto of_normal = length(normal);
  const auto of_tool = length(tool);
  const auto of_across = length(across);
  // Without a flat before and after, the direction across counts for nothing.
  const bool is_ball = move.radius == move.corner && move.radius + move.dr <= move.corner + move.dr2;
  std::optional<std::string> computed;
  if (across == Exact3{})
    computed = of_normal && of_tool ? std::optional(fmt::format("space_flat {} {}", coq(*of_normal), coq(*of_tool)))
                                    : std::nullopt;
  else if (of_normal && of_tool && (of_across || is_ball))
    computed = fmt::format("space_computed {} {} {}", coq(*of_normal), coq(*of_tool),
                           of_across && !is_ball ? coq(*of_across) : "1");
  Lemma lemma = recorded_point(c, move, value, computed);
  if (across == Exact3{} && !computed)
    lemma.text.replace(lemma.text.find("space_by_intervals"), std::string("space_by_intervals").size(),
                       "space_flat_by_intervals");
  return lemma;
}

std::optional<Lemma> flank_lemma(const spec::Case& c, const std::vector<SpaceMove>& moves, std::size_t i) {
  const SpaceMove& move = moves[i];
  const auto compensated = [](const SpaceMove& m) { return m.tcpm && m.side != 0 && !m.normal; };
  if (!compensated(move) || !move.tool || i == 0) return std::nullopt;
  const SpaceMove* next = i + 1 < moves.size() ? &moves[i + 1] : nullptr;
  const bool first = !compensated(moves[i - 1]);
  const bool inner = next != nullptr && compensated(*next);
  const std::string delta = coq(move.contour ? Rational(move.radius + move.dr) : move.dr);
  const auto own = side_of(*move.tool, moves[i - 1].programmed, move.programmed, move.side);
  std::optional<Side> after;
  if (next != nullptr) after = side_of(*move.tool, move.programmed, next->programmed, inner ? next->side : move.side);
  const auto& one = first && next != nullptr ? after : own;
  const bool mitre = !first && inner;
  if (mitre ? !own || !after : !one) return std::nullopt;
  const std::string vector =
      mitre ? fmt::format("(PeripheralMilling.mitre {}\n      {}\n      {})", delta, own->text, after->text)
            : fmt::format("(scale {} {})", delta, one->text);
  const std::string tip = move.contour ? coq(move.programmed)
                                       : fmt::format("(FaceMilling.nominal_tip {} {} {} {})", reference_text(move),
                                                     tool_text(move), coq(move.programmed), coq(*move.tool));
  const auto of_tool = length(*move.tool);
  const bool leans = move.center && !move.contour && move.corner != 0;
  const std::optional<Rational> first_root = mitre ? own->root : one->root;
  const std::optional<Rational> second_root = mitre ? after->root : first_root;
  std::optional<std::string> computed;
  if ((of_tool || !leans) && first_root && second_root)
    computed = fmt::format("flank_computed {} {} {}", leans ? coq(*of_tool) : "1", coq(*first_root), coq(*second_root));
  return recorded_point(c, move, fmt::format("add {}\n      {}", tip, vector), computed);
}

}  // namespace toolcomp::corpus
