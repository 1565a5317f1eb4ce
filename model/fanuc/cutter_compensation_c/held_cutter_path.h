// SPDX-License-Identifier: Apache-2.0
// The path of a block held by cutter compensation C: along which way the tool runs, on which side and how far away.
#pragma once

#include <optional>

#include "model/fanuc/corner/held.h"
#include "model/fanuc/corner/offset_path.h"
#include "model/fanuc/cutter_compensation/cutter_block.h"

namespace toolcomp::model {

class HeldCutterPath final : public HeldPath {
 public:
  HeldCutterPath(spec::Plane plane, OffsetPath path) : path_(std::move(path)), plane_(plane) {}

  [[nodiscard]] const OffsetPath& path() const { return path_; }
  [[nodiscard]] std::optional<ToolArcRun> arc_run(Recorder& recorder, const SpaceVector& from,
                                                  const SpaceVector& to) const override;
  [[nodiscard]] bool arc_interferes(Recorder& recorder, ToolArcRun& run) const override;
  [[nodiscard]] bool line_interferes(Recorder& recorder, const Vector& from, const Vector& to) const override;
  [[nodiscard]] Real backwards(const Vector& from, const Vector& to) const override;
  [[nodiscard]] Real excess() const override { return model::excess(path_.start, path_.end); }

 private:
  OffsetPath path_;
  spec::Plane plane_;
};

// Of a block held that moves.
inline const OffsetPath& path_of(const Held& held) { return static_cast<const HeldCutterPath&>(*held.path).path(); }

// The path of a moving block: at its start with the distance in force before it, each on the block's own side.
OffsetPath path_of(const CutterBlock& block, const CutterOffset& own, const Rational& distance_before);

}  // namespace toolcomp::model
