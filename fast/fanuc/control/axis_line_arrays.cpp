#include "fast/fanuc/control/axis_line_arrays.h"

#include "fast/arithmetic/count.h"
#include "fast/basis/fault.h"

namespace toolcomp::fast {
namespace {

struct SendTo {
  [[gnu::always_inline]] static void run(const double* position, double offset, double* to, std::size_t size) {
    constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
    for (std::size_t i = 0; i < size; ++i) to[i] = (position[i] + offset) / kPerOne;
  }
};

}  // namespace

void send_axis_to(Instructions by, const double* position, double offset, double* to, std::size_t size) {
  run_by<SendTo>(by, position, fault(Fault::axis_lines_without_offset) ? 0 : offset, to, size);
}

}  // namespace toolcomp::fast
