// SPDX-License-Identifier: Apache-2.0
// F, FMAX, F AUTO, FZ, FU.
#pragma once

#include <optional>

#include "model/heidenhain/program/values.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::model::klartext {

// The feed in force, mm/min or inch/min; none behind FZ and FU. Clause: heidenhain.program.feed.
class Feed {
 public:
  explicit Feed(const Values& values) : values_(values) {}

  // The feed word of L and LN.
  void of_block(const spec::klartext::Block& block) {
    if (block.feed == spec::klartext::FeedWord::f_auto)
      in_force_ = of_tool_call_;
    else
      take(block);
  }
  // That of TOOL CALL, to which F AUTO goes back.
  void of_tool_call(const spec::klartext::Block& block) {
    if (take(block)) of_tool_call_ = in_force_;
    if (block.feed == spec::klartext::FeedWord::f_auto) in_force_ = of_tool_call_;
  }
  [[nodiscard]] const std::optional<Real>& in_force() const { return in_force_; }

 private:
  // Whether the block sets a feed.
  bool take(const spec::klartext::Block& block) {
    using spec::klartext::FeedWord;
    if (block.feed == FeedWord::f)
      in_force_ = values_.inch() ? values_.word(block.feed_value) / 10 : values_.word(block.feed_value);
    else if (block.feed == FeedWord::f_z || block.feed == FeedWord::f_u)
      in_force_.reset();
    else
      return false;
    return true;
  }

  const Values& values_;
  std::optional<Real> in_force_;
  std::optional<Real> of_tool_call_;
};

}  // namespace toolcomp::model::klartext
