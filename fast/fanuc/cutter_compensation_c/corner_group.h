// The vectors at a corner of cutter compensation C, in the order the tool goes through them (chapter 14.6.2 to 14.6.4).
#pragma once

#include <array>
#include <cstdint>

#include "fast/geometry/corner.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Parameters that decide which vectors a corner has.
struct CornerParameters {
  // Throws spec::InputError for a limit no control could have.
  explicit CornerParameters(const spec::Setup& setup);

  bool type_b = false;           // 5003#0, SUP
  bool acts_alone = false;       // 5003#1, SUV
  bool keeps_mode = false;       // 5003#2, CCN
  bool no_interference = false;  // 5008#0, CNI
  Count limit;                   // 5010
  double limit_value = 0;
  bool negative_limit = false;
};

struct Head {
  Vector2<double> vector;
  HeadKind kind = HeadKind::zero;
};

// At most four vectors (arc - acute corner - arc). G53 may clear one component of the only vector of a group.
struct CornerGroup {
  std::array<Head, 4> head{};
  std::uint8_t size = 1;
  std::uint8_t cleared = 0;  // bit i: component i
  Corner corner;

  [[nodiscard]] const Head& front() const { return head[0]; }
  [[nodiscard]] const Head& back() const { return head[size - 1U]; }
  void clear() {
    size = 1;
    cleared = 0;
    head[0] = {};
  }
  void add(HeadKind kind) { head[size++] = {head_vector(corner, kind), kind}; }
  void set(HeadKind kind) { set(kind, head_vector(corner, kind)); }
  void set(HeadKind kind, const Vector2<double>& vector) {
    size = 1;
    cleared = 0;
    head[0] = {vector, kind};
  }
  // The vector of a head to about 90 bits.
  [[nodiscard]] Vector2<DoubleDouble> fine(std::size_t index) const {
    Vector2<DoubleDouble> v = fine_head_vector(corner, head[index].kind);
    if ((cleared & 1U) != 0) v.x = {};
    if ((cleared & 2U) != 0) v.y = {};
    return v;
  }
  void drop_last() { --size; }
  void drop_first() {
    for (std::uint8_t i = 1; i < size; ++i) head[i - 1U] = head[i];
    --size;
  }
};

// How two blocks meet.
enum class CornerRule : std::uint8_t {
  ordinary,   // both in the offset mode
  start_up,   // the former one starts it
  cancel,     // the latter one ends it
  direction,  // the latter one ends it with G40 and I J, along which corner.next lies
  repeated,   // G41 or G42 again
};

// Fills the group of group.corner, whose turn is set. False where the offset paths of an inner corner do not meet
// (PS0033).
bool make_group(CornerGroup& group, CornerRule rule, const CornerParameters& parameters);

}  // namespace toolcomp::fast
