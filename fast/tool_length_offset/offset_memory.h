// Tool offset memory A, B, C (chapter 14.8).
#pragma once

#include <cstdint>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/program/alarm.h"
#include "spec/language/name.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Values in setup units, exact.
class OffsetMemory {
 public:
  // Throws spec::InputError for more offsets than a control has, and for values no control could hold.
  explicit OffsetMemory(const spec::Setup& setup);

  [[nodiscard]] std::uint32_t count() const { return count_; }
  // Geometry plus wear; 0 for number 0 and for numbers never set. `number` is at most count().
  [[nodiscard]] Count h(std::uint32_t number) const { return h_[number].geometry + h_[number].wear; }
  [[nodiscard]] Count d(std::uint32_t number) const { return d_[number].geometry + d_[number].wear; }
  // Whether an effective value is within the range of the memory.
  [[nodiscard]] bool fits(const Count& value) const { return within(value, geometry_limit_); }

  // One G10 write.
  struct Write {
    Alarm alarm;
    spec::Name setting;  // "H1", "D2.wear"
    Count value;         // stored
    bool changes_h = false;
  };
  // G10 L P R: sets, or adds to, one stored value. Nothing is written where there is an alarm.
  Write write(std::uint32_t list, std::uint32_t number, const Count& value, bool add);

 private:
  struct Entry {
    Count geometry;
    Count wear;
  };
  [[nodiscard]] static bool within(const Count& value, const Count& limit) { return !(limit < value) && !(value < -limit); }

  spec::OffsetMemory kind_;
  std::uint32_t count_;
  Count geometry_limit_;
  Count wear_limit_;
  std::vector<Entry> h_;
  std::vector<Entry> d_;
};

}  // namespace toolcomp::fast
