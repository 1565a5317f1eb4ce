// SPDX-License-Identifier: Apache-2.0
#include "fuzz/faults/wrong_clauses.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::fuzz {
namespace {

using exact::Real;
using exact::Sign;
using Vector = std::array<Real, 3>;

constexpr std::uint64_t kBudget = 50'000;

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

spec::Case forty_four_as_forty_three(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "G44", "G43");
  return other;
}

spec::Case forty_six_as_forty_five(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "G46", "G45");
  return other;
}

spec::Case reads_past_stops(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "M00", "M05");
  replace_all(other.program, "M01", "M05");
  return other;
}
spec::Case positive_rotary_words(const spec::Case& c) {
  spec::Case other = c;
  for (const std::string_view word : {" A-", " B-", " C-"})
    replace_all(other.program, word, std::string(word.substr(0, 2)) + "+");
  return other;
}

spec::Case positive_values(const spec::Case& c) {
  spec::Case other = c;
  for (auto* offsets : {&other.setup.d, &other.setup.h})
    for (auto& [number, entry] : *offsets) entry.geometry.negative = entry.wear.negative = false;
  return other;
}

spec::Case negated_values(const spec::Case& c) {
  spec::Case other = c;
  for (auto* offsets : {&other.setup.d, &other.setup.h})
    for (auto& [number, entry] : *offsets) {
      entry.geometry.negative = !entry.geometry.negative;
      entry.wear.negative = !entry.wear.negative;
    }
  return other;
}

spec::Case without_holder_offset(const spec::Case& c) {
  spec::Case other = c;
  other.setup.parameters.erase({19666, -1});
  return other;
}

spec::Case without_shift(const spec::Case& c) {
  spec::Case other = c;
  other.setup.parameters.erase({5006, 6});
  return other;
}

spec::Case other_sense(const spec::Case& c) {
  spec::Case other = c;
  spec::Decimal& sense = other.setup.parameters[{19689, -1}];
  sense = spec::decimal(sense.is_zero() ? 1 : 0);
  return other;
}

spec::Case lean_backward(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "Q-", "Q+");
  replace_all(other.program, "Q", "Q-");
  replace_all(other.program, "Q-+", "Q");
  return other;
}

spec::Case conventional(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "P1", "P0");
  other.setup.parameters[{19604, 0}] = spec::decimal(0);
  return other;
}

spec::Case without_veto(const spec::Case& c) {
  spec::Case other = c;
  other.setup.parameters[{19739, -1}] = spec::decimal(360);
  return other;
}

spec::Case without_radius_delta(const spec::Case& c) {
  spec::Case other = c;
  for (spec::ToolRow& tool : other.setup.tools) tool.dr = {};
  return other;
}

spec::Case sides_exchanged(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, " RL", " R?");
  replace_all(other.program, " RR", " RL");
  replace_all(other.program, " R?", " RR");
  return other;
}

// The move of a G49 that ends tool center point control ends 1 beside where it should.
void take_back_too_little(const spec::Case& c, std::vector<model::Event>& events) {
  if (c.setup.tip_control_cancel != spec::TipControlCancel::moves) return;
  for (std::size_t i = 1; i < events.size(); ++i) {
    const bool ends = events[i - 1].tool_axis && !events[i - 1].machine.empty() && events[i].machine.empty();
    if (!ends || events[i].kind != spec::EventKind::move) continue;
    for (auto* values : {&events[i].programmed, &events[i].point, &events[i].axes}) values->value[0] += Real(1);
  }
}

void reverse_difference(const spec::Case& c, std::vector<model::Event>& events) {
  for (model::Event& event : events) {
    if (event.kind != spec::EventKind::setting || !event.setting.view().starts_with("H")) continue;
    const auto number = static_cast<std::uint32_t>(std::stoul(std::string(event.setting.view().substr(1))));
    const auto entry = c.setup.h.find(number);
    if (entry == c.setup.h.end()) continue;
    const spec::Decimal& old = event.setting.view().ends_with(".wear") ? entry->second.wear : entry->second.geometry;
    exact::Rational value(old.digits, exact::power_of_ten(old.decimals));
    if (old.negative) value = -value;
    event.value = Real(value) + Real(value) - event.value;
  }
}

Vector xyz(const spec::Axes& axes, const spec::AxisValues<Real>& values) {
  Vector v;
  for (std::size_t i = 0; i < v.size(); ++i) v.at(i) = values[axes.index("XYZ"[i])];
  return v;
}

bool parallel(const Vector& a, const Vector& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

// The end of a block displaced along the tool of the block before takes that block's last vector.
void keep_along_the_former_tool(const spec::Case& c, std::vector<model::Event>& events) {
  const spec::Axes& axes = c.setup.axes;
  const model::Event* before = nullptr;
  for (model::Event& event : events) {
    if (event.kind != spec::EventKind::move) continue;
    const bool own = event.cause == spec::Cause::programmed && event.tool_axis;
    if (before != nullptr && own && before->tool_axis && !parallel(*before->tool_axis, *event.tool_axis)) {
      const Vector from = xyz(axes, before->programmed);
      const Vector to = xyz(axes, event.programmed);
      Vector way;
      bool moves = false;
      for (std::size_t i = 0; i < way.size(); ++i) {
        way.at(i) = to.at(i) - from.at(i);
        moves = moves || way.at(i).sign() != Sign::zero;
      }
      if (moves && parallel(way, *before->tool_axis))
        for (std::size_t i = 0; i < way.size(); ++i) {
          const std::size_t axis = axes.index("XYZ"[i]);
          const Real kept = before->point[axis] - before->programmed[axis] + event.programmed[axis];
          event.axes.value.at(axis) += kept - event.point[axis];
          event.point.value.at(axis) = kept;
        }
    }
    before = &event;
  }
}

// The vector at the end of an arc is taken with the sense of the arc in its plane, although the tool sees it from
// below.
void sense_from_above(const spec::Case& c, std::vector<model::Event>& events) {
  const spec::Axes& axes = c.setup.axes;
  for (model::Event& event : events) {
    if (event.kind != spec::EventKind::move || event.cause != spec::Cause::programmed || !event.arc || !event.tool_axis)
      continue;
    const std::size_t across = event.arc->plane == spec::Plane::xy ? 2 : event.arc->plane == spec::Plane::zx ? 1 : 0;
    if (event.tool_axis->at(across).sign() != Sign::negative) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = axes.index("XYZ"[i]);
      const Real mirrored = event.programmed[axis] + event.programmed[axis] - event.point[axis];
      event.axes.value.at(axis) += mirrored - event.point[axis];
      event.point.value.at(axis) = mirrored;
    }
  }
}

// The block before G92 ends with the vector it started with.
void keep_before_a_shift(const spec::Case& c, std::vector<model::Event>& events) {
  const spec::Axes& axes = c.setup.axes;
  std::vector<std::uint64_t> shifts;
  std::uint64_t line = 1;
  for (std::size_t at = 0; at < c.program.size(); ++at) {
    if (c.program.compare(at, 3, "G92") == 0) shifts.push_back(line);
    if (c.program[at] == '\n') ++line;
  }
  std::vector<model::Event*> moves;
  for (model::Event& event : events)
    if (event.kind == spec::EventKind::move) moves.push_back(&event);
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    const auto renames = [&](std::uint64_t shift) { return moves[i]->line < shift && shift < moves[i + 1]->line; };
    if (std::ranges::none_of(shifts, renames)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!axes.has("XYZ"[k])) continue;
      const std::size_t axis = axes.index("XYZ"[k]);
      const Real kept = moves[i - 1]->point[axis] - moves[i - 1]->programmed[axis];
      moves[i]->point.value.at(axis) += kept;
      moves[i]->axes.value.at(axis) += kept;
    }
  }
}

spec::Case ninety_nine_as_ninety_eight(const spec::Case& c) {
  spec::Case other = c;
  replace_all(other.program, "G99", "G98");
  return other;
}

// The repeats of a block drill in one place.
void drill_in_one_place(const spec::Case& /*c*/, std::vector<model::Event>& events) {
  for (std::size_t i = 1; i < events.size(); ++i)
    if (events[i].hole && events[i - 1].hole && events[i].line == events[i - 1].line) {
      events[i].point = events[i - 1].point;
      events[i].axes = events[i - 1].axes;
    }
}

// Behind a hole the axes stand where the tool does.
void drill_without_length(const spec::Case& /*c*/, std::vector<model::Event>& events) {
  for (model::Event& event : events) {
    if (!event.hole) continue;
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (event.point.has(i)) event.axes.set(i, event.point[i]);
    event.axes.set(event.hole->axis, event.hole->level);
  }
}

// The second set-up clearance never counts.
void return_to_the_first_clearance(const spec::Case& /*c*/, std::vector<model::Event>& events) {
  for (model::Event& event : events) {
    if (!event.hole) continue;
    event.axes.value.at(event.hole->axis) += event.hole->point_r - event.hole->level;
    event.hole->level = event.hole->point_r;
  }
}

// A hole lies where the compensated tool of the move before it stands, not at the programmed position.
void drill_beside_the_position(const spec::Case& /*c*/, std::vector<model::Event>& events) {
  const model::Event* before = nullptr;
  for (model::Event& event : events) {
    if (event.kind == spec::EventKind::move) before = &event;
    if (!event.hole || before == nullptr) continue;
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (event.point.has(i) && before->point.has(i)) {
        event.point.set(i, before->point[i]);
        event.axes.set(i, before->point[i]);
      }
  }
}

constexpr WrongClause kWrong[] = {
    {"side_along_the_former_tool", "fanuc/tool-side-compensation", "perpendicular-to-the-tool", kBudget, nullptr,
     keep_along_the_former_tool},
    {"side_negative_value", "fanuc/tool-side-compensation", "beside-the-line-before", kBudget, positive_values,
     nullptr},
    {"side_arc_from_above", "fanuc/tool-side-compensation", "beside-the-arc", kBudget, nullptr, sense_from_above},
    {"edge_sense", "fanuc/leading-edge-offset", "leading-edge-vector", kBudget, negated_values, nullptr},
    {"length_44_as_43", "fanuc/tool-length-offset", "length-offset", kBudget, forty_four_as_forty_three, nullptr},
    {"system_not_shifted", "fanuc/tool-length-offset", "by-the-words-alone", kBudget, without_shift, nullptr},
    {"measured_reversed", "fanuc/tool-length-measurement", "measured-difference", kBudget, nullptr, reverse_difference},
    {"offset_46_as_45", "fanuc/tool-offset", "signed-sums", kBudget, forty_six_as_forty_five, nullptr},
    {"hole_repeats_in_one_place", "fanuc/canned-cycle", "hole-where-commanded", kBudget, nullptr, drill_in_one_place},
    {"hole_return_99_as_98", "fanuc/canned-cycle", "hole-levels", kBudget, ninety_nine_as_ninety_eight, nullptr},
    {"hole_without_length", "fanuc/canned-cycle", "hole-axes", kBudget, nullptr, drill_without_length},
    {"cutter_b_negative_value", "fanuc/cutter-compensation-b", "normal-of-the-block", kBudget, positive_values,
     nullptr},
    {"cutter_c_negative_value", "fanuc/cutter-compensation-c", "beside-the-line-before", kBudget, positive_values,
     nullptr},
    {"cutter_c_kept_by_92", "fanuc/cutter-compensation-c", "where-the-tool-is-said-to-be", kBudget, nullptr,
     keep_before_a_shift},
    {"cutter_c_reads_past_stops", "fanuc/cutter-compensation-c", "cut-at-a-stop", kBudget, reads_past_stops, nullptr},
    {"tip_without_holder_offset", "fanuc/tool-center-point-control", "tip-of-the-axes", kBudget, without_holder_offset,
     nullptr},
    {"taken_back_too_little", "fanuc/tool-center-point-control", "offset-taken-back", kBudget, nullptr,
     take_back_too_little},
    {"tip_sense", "fanuc/tool-center-point-control", "axis-of-the-positions", kBudget, other_sense, nullptr},
    {"tip_leans_backward", "fanuc/tool-center-point-control", "commanded-direction", kBudget, lean_backward, nullptr},
    {"posture_conventional", "fanuc/tool-posture-control", "great-circle", kBudget, conventional, nullptr},
    {"posture_error_unlimited", "fanuc/tool-posture-control", "changed-end", kBudget, without_veto, nullptr},
    {"face_radius_delta", "heidenhain/face-milling", "touches-the-contact-plane", kBudget, without_radius_delta,
     nullptr},
    {"rotary_words_without_sign", "heidenhain/face-milling", "tool-as-the-axes-stand", kBudget, positive_rotary_words,
     nullptr},
    {"peripheral_sides", "heidenhain/peripheral-milling", "cylinder-beside-the-line", kBudget, sides_exchanged,
     nullptr},
    {"cycle_return_without_204", "heidenhain/face-milling", "hole-by-its-parameters", kBudget, nullptr,
     return_to_the_first_clearance},
    {"cycle_without_length", "heidenhain/programmed-contour", "hole-with-length", kBudget, nullptr,
     drill_without_length},
    {"cycle_beside_the_position", "heidenhain/peripheral-milling", "hole-where-programmed", kBudget, nullptr,
     drill_beside_the_position},
};

}  // namespace

std::span<const WrongClause> wrong_clauses() { return kWrong; }

judge::Trial try_wrong(const WrongClause& wrong, const spec::Case& c) {
  const spec::Case altered = wrong.altered != nullptr ? wrong.altered(c) : c;
  judge::Trial trial;
  try {
    trial.run = judge::run_model(altered);
    trial.verdict = judge::judge(altered, trial.run, judge::run_fast(altered));
    if (wrong.events != nullptr) wrong.events(c, trial.run.events);
    trial.law_checks = judge::hold_laws(c, trial.run, trial.verdict);
  } catch (const spec::InputError&) {
    // A setup that the control could not have.
    trial.acceptance = judge::Acceptance::no_setup;
  } catch (const exact::Undecided&) {
    trial.acceptance = judge::Acceptance::not_decided;
  }
  return trial;
}

}  // namespace toolcomp::fuzz
