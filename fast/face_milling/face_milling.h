// Face milling: LN blocks with a surface normal (heidenhain.face.*, sheet 5.2 to 5.4).
#pragma once

#include "fast/klartext/effective_tool.h"
#include "fast/klartext/event_writer.h"
#include "fast/klartext/tool_vector.h"
#include "fast/programmed_contour/programmed_contour.h"

namespace toolcomp::fast::klartext {

// N x T is made of whole numbers, exactly: nothing is lost where N is nearly along T.
class FaceMilling {
 public:
  explicit FaceMilling(EventWriter& writer) : writer_(writer) {}

  // The surface normal of the block to come, to be written.
  [[nodiscard]] WholeVector& normal() { return normal_; }
  // The first alarm of sheet 5.1 or 5.9; with a table of deviations it is looked up. `along`: the tool stands along the
  // normal.
  [[nodiscard]] Alarm check(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted) {
    if (effective.deviations() == nullptr) [[likely]]
      return effective.check(true, permitted);
    return deviate(tool, along, effective, permitted);
  }
  // The block checked: its warnings, which are added to those of the head, and its move.
  void mill(MoveHead& head, const ToolVector& tool, bool along, const ProgrammedPoint& programmed,
            const EffectiveTool& effective, spec::Cause cause);
  // Any other motion and TOOL CALL: no contact is before the next.
  void forget() { before_.any = false; }

 private:
  // Normal and tool, unit; u = t x (n x t)/|n x t|, and 0 where w = 0.
  struct Meeting {
    Vector n, t, u;
    bool flat = false;  // w = 0
    double sine = 0;    // |n x T|, T in its own units
    double cosine = 1;  // n.t
  };
  [[gnu::always_inline]] [[nodiscard]] Meeting meet(const ToolVector& tool, bool along) const;
  void meet_wide(const ToolVector& tool, Meeting& meeting) const;
  [[nodiscard]] Alarm deviate(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted);
  [[nodiscard]] bool below(double cosine, const ToolVector& tool) const;
  [[nodiscard]] bool jump(const Meeting& meeting, const ToolVector& tool) const;

  EventWriter& writer_;
  WholeVector normal_;
  // With a table of deviations, of the block checked.
  double corner_delta_ = 0;
  double degrees_ = 0;

  // The contact of the block before.
  struct Before {
    bool any = false;
    bool flat = false;
    Vector u;
    WholeVector normal, tool;
  };
  Before before_;
};

}  // namespace toolcomp::fast::klartext
