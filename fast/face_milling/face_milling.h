// Face milling: LN blocks with a surface normal (heidenhain.face.*, sheet 5.2 to 5.4).
#pragma once

#include "fast/klartext/effective_tool.h"
#include "fast/klartext/event_writer.h"
#include "fast/klartext/tool_vector.h"
#include "fast/programmed_contour/programmed_contour.h"

namespace toolcomp::fast::klartext {

// One block is met (vectors, verdict, warnings), then sent. What is computed from what:
// u is t x (N x T)/|N x T|, the cross product of whole numbers being exact: nothing is lost where N is nearly along T.
class FaceMilling {
 public:
  explicit FaceMilling(EventWriter& writer) : writer_(writer) {}

  // The surface normal of the block to come, to be written.
  [[nodiscard]] WholeVector& normal() { return normal_; }
  // The block: `along` where the tool stands along the normal. The first alarm of sheet 5.1 or 5.9.
  [[nodiscard]] Alarm meet(const ToolVector& tool, bool along, const EffectiveTool& effective, bool permitted);
  // Warnings of the block met; afterwards its contact is the one before.
  [[nodiscard]] Warnings warnings(const ToolVector& tool, const EffectiveTool& effective);
  // The move of the block met.
  void send(const MoveHead& head, const ProgrammedPoint& programmed, const EffectiveTool& effective, spec::Cause cause);
  // Any other motion and TOOL CALL: no contact is before the next.
  void forget() { before_.any = false; }

 private:
  [[nodiscard]] Alarm deviate(const ToolVector& tool, const EffectiveTool& effective, bool permitted);
  void cross_exactly(const ToolVector& tool);
  [[nodiscard]] bool below(const ToolVector& tool) const;
  [[nodiscard]] bool jump(const ToolVector& tool) const;

  EventWriter& writer_;
  WholeVector normal_;

  // Of the block met.
  Vector n_, t_, u_;
  bool flat_ = false;  // w = 0
  double sine_ = 0;    // |n x T|, T in its own units
  double cosine_ = 1;  // n.t
  double corner_delta_ = 0;
  double degrees_ = 0;  // contact angle, with a table of deviations

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
