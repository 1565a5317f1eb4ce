// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/program/effective_tool.h"

#include <algorithm>

#include "spec/language/input_error.h"

namespace toolcomp::fast::klartext {
namespace {

bool negative(const Count& value) { return value < Count{}; }
bool positive(const Count& value) { return Count{} < value; }

void require(const spec::Decimal& value, const std::string& key) {
  // A few of them are added, and 127/5 times as many tenths of an inch must fit.
  if (value.decimals == 0 && value.digits >= 1'000'000'000'000'000U)
    throw spec::InputError("setup", 0, 0, key + ": must be below 1e15");
}

}  // namespace

EffectiveTool::EffectiveTool(const spec::Setup& setup) : setup_(setup) {
  for (const spec::ToolRow& row : setup.tools) {
    for (const spec::Decimal* value : {&row.r, &row.r2, &row.dl, &row.dr, &row.dr2}) require(*value, "tool");
    if (row.l) require(*row.l, "tool");
    if (!row.dr2_table.empty() && !setup.dr2_tables.contains(row.dr2_table))
      throw spec::InputError("setup", 0, 0, "tool.DR2TABLE: no dr2table of this name");
  }
  for (const auto& [number, row] : setup.tcs)
    for (const spec::Decimal* value : {&row.dl, &row.dr, &row.dr2}) require(*value, "correction.tcs");
  for (const auto& [name, points] : setup.dr2_tables) {
    for (const auto& [angle, deviation] : points) require(deviation, "dr2table");
    tables_.emplace_back(points);
  }
  update();
}

void EffectiveTool::set_units(bool inch) {
  factor_ = inch ? Factor::mm_to_inch : Factor::one;
  for (DeviationTable& table : tables_) table.set_units(factor_);
}

bool EffectiveTool::call(std::uint32_t number) {
  if (number == 0) {
    take(nullptr);
    return true;
  }
  const auto row = std::ranges::find(setup_.tools, number, &spec::ToolRow::number);
  if (row == setup_.tools.end()) return false;
  take(&*row);
  return true;
}

bool EffectiveTool::call(std::string_view name) {
  if (name.empty()) return false;
  const auto row = std::ranges::find(setup_.tools, name, &spec::ToolRow::name);
  if (row == setup_.tools.end()) return false;
  take(&*row);
  return true;
}

void EffectiveTool::take(const spec::ToolRow* row) {
  called_ = true;
  call_ = {};
  row_ = {};
  deviations_ = nullptr;
  length_.reset();
  if (row == nullptr) {
    radius_ = corner_ = Count{};
    own_ = {};
  } else {
    radius_ = table(row->r);
    corner_ = table(row->r2);
    if (row->l) length_ = table(*row->l);
    own_ = {table(row->dl), table(row->dr), table(row->dr2)};
    if (!row->dr2_table.empty()) {
      std::size_t index = 0;
      for (const auto& [name, points] : setup_.dr2_tables) {
        if (name == row->dr2_table) deviations_ = &tables_[index];
        ++index;
      }
    }
  }
  update();
}

void EffectiveTool::set_call_length(const Count& value) {
  call_.length = value;
  update();
}
void EffectiveTool::set_call_radius(const Count& value) {
  call_.radius = value;
  update();
}
void EffectiveTool::set_call_corner(const Count& value) {
  call_.corner = value;
  update();
}

void EffectiveTool::set_row(std::optional<std::uint32_t> row) {
  row_ = {};
  if (row)
    if (const auto found = setup_.tcs.find(*row); found != setup_.tcs.end())
      row_ = {table(found->second.dl), table(found->second.dr), table(found->second.dr2)};
  update();
}

void EffectiveTool::update() {
  const Count length_delta = own_.length + call_.length + row_.length;
  const Count radius_delta = own_.radius + call_.radius + row_.radius;
  const Count added_corner = call_.corner + row_.corner;
  const Count corner_delta = own_.corner + added_corner;
  const Count effective_radius = radius_ + radius_delta;
  const Count effective_corner = corner_ + corner_delta;
  const Count ring = radius_ - corner_;
  Count effective_ring = effective_radius - effective_corner;
  const bool beyond = negative(effective_ring);
  if (beyond) effective_ring = Count{};

  values_.corner = corner_.nearest();
  values_.ring = ring.nearest();
  values_.radius_delta = radius_delta.nearest();
  values_.corner_delta = corner_delta.nearest();
  values_.length_delta = length_delta.nearest();
  values_.effective_radius = effective_radius.nearest();
  values_.effective_corner = effective_corner.nearest();
  values_.effective_ring = effective_ring.nearest();
  values_.ring_delta = (effective_ring - ring).nearest();
  values_.has_ring = !ring.is_zero() || !effective_ring.is_zero();
  values_.has_length = length_.has_value();
  values_.length = length_ ? (*length_ + length_delta).nearest() : 0;
  corner_without_deviation_ = corner_ + added_corner;
  nearest_corner_without_deviation_ = corner_without_deviation_.nearest();
  corner_delta_without_deviation_ = added_corner.nearest();

  // In the order of heidenhain.tool.order-of-checks; the first one counts.
  const bool table = negative(radius_) || negative(corner_) || negative(ring);
  const auto first = [](std::initializer_list<std::pair<bool, AlarmCause>> checks) {
    for (const auto& [holds, cause] : checks)
      if (holds) return cause;
    return AlarmCause::none;
  };
  const bool shrunk = negative(effective_radius);
  const bool corner_negative = negative(effective_corner);
  const bool oversize = positive(radius_delta);
  const Alarm always = first({{table, AlarmCause::tool_shape},
                              {shrunk, AlarmCause::effective_radius},
                              {corner_negative, AlarmCause::corner_radius_negative}});
  const Alarm radius = first({{oversize, AlarmCause::oversize_radius}});
  const Alarm corner =
      first({{positive(corner_delta), AlarmCause::oversize_corner}, {beyond, AlarmCause::corner_beyond_radius}});
  verdict_[0][1] = verdict_[1][1] = always;
  verdict_[0][0] = always ? always : radius;
  verdict_[1][0] = always ? always : (radius ? radius : corner);
  before_angle_ = first({{table, AlarmCause::tool_shape},
                         {!ring.is_zero(), AlarmCause::deviation_shape},
                         {shrunk, AlarmCause::effective_radius}});
  after_angle_[1] = AlarmCause::none;
  after_angle_[0] =
      first({{oversize, AlarmCause::oversize_radius}, {positive(added_corner), AlarmCause::oversize_corner}});
}

}  // namespace toolcomp::fast::klartext
