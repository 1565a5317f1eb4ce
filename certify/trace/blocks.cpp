// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/blocks.h"

#include <type_traits>

#include "judge/oracle/control.h"

namespace toolcomp::certify {
namespace {

template <class Control>
class BlocksOf : public Blocks {
 public:
  BlocksOf(const spec::Case& c, model::EventSink& events, model::MotionSink& motions)
      : reader_(Control::reader(spec::text_source(c.program), c.setup, "program")),
        block_(std::make_unique<typename Control::Block>()),
        model_(make(c.setup, recorder_, events, motions)) {}

  bool next() override {
    if (ended_) return false;
    if (!model_.stopped() && reader_.next(*block_)) {
      model_.block(*block_);
      return true;
    }
    ended_ = true;
    model_.end();
    return true;
  }

 private:
  static typename Control::Model make(const spec::Setup& setup, model::Recorder& recorder, model::EventSink& events,
                                      model::MotionSink& motions) {
    if constexpr (std::is_same_v<Control, judge::FanucControl>)
      return typename Control::Model(setup, recorder, events, 0, &motions);
    else
      return typename Control::Model(setup, recorder, events);
  }

  model::Recorder recorder_;
  typename Control::Reader reader_;
  std::unique_ptr<typename Control::Block> block_;
  typename Control::Model model_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Blocks> blocks_of(const spec::Case& c, model::EventSink& events, model::MotionSink& motions) {
  std::unique_ptr<Blocks> blocks;
  judge::with_control(
      c.setup, [&]<class Control>(Control) { blocks = std::make_unique<BlocksOf<Control>>(c, events, motions); });
  return blocks;
}

}  // namespace toolcomp::certify
