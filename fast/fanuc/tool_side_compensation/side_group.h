// The vectors at a corner of tool side compensation, in the order the tool goes through them (3D sheet 2.3 to 2.7).
#pragma once

#include <array>
#include <cstdint>

#include "fast/fanuc/cutter_compensation_c/corner_group.h"
#include "fast/fanuc/tool_side_compensation/plane_change.h"
#include "fast/fanuc/tool_side_compensation/side_corner.h"
#include "fast/fanuc/tool_side_compensation/tool_side_block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Start-up and cancel.
enum class StartType : std::uint8_t { a, b, c };

struct SideParameters {
  // Throws spec::InputError for parameters no control could have.
  explicit SideParameters(const spec::Setup& setup);

  StartType type = StartType::a;  // 5003#0 SUP, 5003#1 SUV
  bool bare_b = false;            // type B without the perpendicular vector of lines
  bool no_interference = false;   // 5008#0, CNI
  bool no_plane_change = false;   // 19605#5, NIC
  PlaneChangeLimit tilt;          // 6261
  Count no_movement;              // 19630; 0 or less: none
  Count small;                    // 5010
  double small_value = 0;
  bool keeps_all = false;  // 5010 is negative
};

struct SideHead {
  Vector3<double> vector;
  HeadKind kind = HeadKind::zero;
  bool kept = false;  // of a corner before: SideGroup::kept
  // The single-block stop point is the head of the intersection or of the first prolonged vector: moves up to it belong
  // to the block before the corner.
  [[nodiscard]] bool up_to_stop() const { return kind != HeadKind::second_normal && kind != HeadKind::second_extended; }
};

// At most four vectors (arc - acute corner - arc).
struct SideGroup {
  std::array<SideHead, 4> head{};
  std::uint8_t size = 1;
  SideCorner corner;
  Vector3<DoubleDouble> kept;

  [[nodiscard]] const SideHead& front() const { return head[0]; }
  [[nodiscard]] const SideHead& back() const { return head[size - 1U]; }
  void clear() {
    size = 1;
    head[0] = {};
  }
  void drop_last() { --size; }
  void drop_first() {
    for (std::uint8_t i = 1; i < size; ++i) head[i - 1U] = head[i];
    --size;
  }
};

class SideGroups {
 public:
  SideGroups(const SideGeometry& geometry, const SideParameters& parameters)
      : geometry_(geometry), parameters_(parameters) {}

  // Fills the group of group.corner, whose turn is set. False where the offset paths of an inner corner do not meet.
  [[nodiscard]] bool make(SideGroup& group, CornerRule rule, Treatment treatment) const;
  void set(SideGroup& group, HeadKind kind) const {
    group.size = 0;
    add(group, kind);
  }
  // The last vector alone, without the corner it was made at.
  void keep_last(SideGroup& group) const {
    group.kept = fine(group, group.size - 1U);
    group.head[0] = group.back();
    group.head[0].kept = true;
    group.size = 1;
  }
  // A vector to about 90 bits.
  [[nodiscard]] Vector3<DoubleDouble> fine(const SideGroup& group, std::size_t i) const {
    const SideHead& head = group.head[i];
    return head.kept ? group.kept : geometry_.fine_vector(group.corner, head.kind);
  }
  [[nodiscard]] const SideGeometry& geometry() const { return geometry_; }

 private:
  void add(SideGroup& group, HeadKind kind) const {
    group.head[group.size++] = {geometry_.vector(group.corner, kind), kind};
  }
  // With an arc: the vector where the offset paths meet. False where they do not.
  [[nodiscard]] static bool set_meeting(SideGroup& group, HeadKind kind);
  void add_outer(SideGroup& group) const;
  [[nodiscard]] bool make_ordinary(SideGroup& group) const;
  void make_start_up(SideGroup& group) const;
  void make_cancel(SideGroup& group) const;
  void make_side_change(SideGroup& group) const;
  [[nodiscard]] bool is_within(const SideGroup& group, std::size_t a, std::size_t b) const;
  void drop_small_movements(SideGroup& group) const;

  const SideGeometry& geometry_;
  const SideParameters& parameters_;
};

}  // namespace toolcomp::fast
