// SPDX-License-Identifier: Apache-2.0
// The vectors at a corner, in the order the tool goes through them (chapter 14.6.2 to 14.6.4): in cutter compensation C
// they lie in the selected plane, in tool side compensation in the plane of the tool.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/geometry/corner.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// No. 19625 at the most.
inline constexpr unsigned kMostBlocksRead = 8;

// Parameters that decide which vectors a corner has.
struct CornerParameters {
  // Throws spec::InputError for a limit no control could have.
  explicit CornerParameters(const spec::Setup& setup);

  bool type_b = false;           // 5003#0, SUP
  bool no_interference = false;  // 5008#0, CNI
  Count limit;                   // 5010
  double limit_value = 0;
  bool keeps_all = false;  // 5010 is negative
  // So many blocks that do not move end the path before them: one less than are read at a time (19625, 3).
  unsigned still_limit = 2;
  [[nodiscard]] DoubleDouble fine_limit() const {
    return to_double_double(limit.units()) / to_double_double(Count::kRestPerOne);
  }
};
// A length in setup units; 0 where the setup has none. Throws spec::InputError for one no control could have.
Count length_parameter(const spec::Setup& setup, std::uint32_t number);

// How two blocks meet.
enum class CornerRule : std::uint8_t {
  ordinary,   // both in the offset mode
  start_up,   // the former one starts it
  cancel,     // the latter one ends it
  direction,  // the latter one ends it with G40 and I J, along which the corner's second tangent lies
  repeated,   // a code of the section again
};

// The single-block stop point is the head of the intersection or of the first prolonged vector.
inline bool is_up_to_stop(HeadKind kind) {
  return kind != HeadKind::second_normal && kind != HeadKind::second_extended;
}

// At most four vectors (arc - acute corner - arc). A head has a vector and its kind.
template <class HeadType, class CornerType>
struct HeadGroup {
  using Vector = decltype(HeadType::vector);
  std::array<HeadType, 4> head{};
  std::uint8_t size = 1;
  CornerType corner;

  [[nodiscard]] const HeadType& front() const { return head[0]; }
  [[nodiscard]] const HeadType& back() const { return head[size - 1U]; }
  void clear() {
    size = 1;
    head[0] = {};
  }
  void drop_last(std::size_t count) { size = static_cast<std::uint8_t>(size - count); }
  void drop_first(std::size_t count) {
    if (count == 0) return;
    for (std::size_t i = count; i < size; ++i) head[i - count] = head[i];
    drop_last(count);
  }
};

// Which vectors a corner has. A section derives from it and gives, of a corner,
//   cross, along             numbers with the signs of sine and cosine of the turn, counted to the left
//   set_vector               the vector of a kind
//   meet                     the vector where the offset paths meet or cross; false where they do not
//   in_plane                 a corner with an arc, in plane coordinates
//   is_under_one_degree      whether an acute corner of lines is: the tangent of its angle is below that of 1 degree
//   is_small_movement        whether two heads are no further from each other than No. 5010
// and, of itself,
//   starts_with_normal, cancels_with_normal   in type B: the vector perpendicular to the block that starts or ends
template <class Section, class Group>
class CornerGroups {
 public:
  // Fills the group of group.corner, whose turn is set. False where the offset paths of an inner corner do not meet
  // (PS0033).
  [[nodiscard]] bool make(Group& group, CornerRule rule) const;
  void set(Group& group, HeadKind kind) const {
    group.size = 0;
    add(group, kind);
  }
  // In place: what is copied right behind its making is waited for.
  void add(Group& group, HeadKind kind) const {
    auto& head = group.head[group.size++];
    head = {};
    head.kind = kind;
    section().set_vector(group.corner, kind, head.vector);
  }

 protected:
  static bool first_is_arc(const Group& group) { return group.corner.first->arc; }
  static bool second_is_arc(const Group& group) { return group.corner.second != nullptr && group.corner.second->arc; }
  static bool is_of_lines(const Group& group) { return !first_is_arc(group) && !second_is_arc(group); }

  const CornerParameters& parameters_;

 private:
  friend Section;
  explicit CornerGroups(const CornerParameters& parameters) : parameters_(parameters) {}
  [[nodiscard]] const Section& section() const { return static_cast<const Section&>(*this); }
  static bool is_straight(const Group& group) {
    return Section::cross(group.corner) == 0 && Section::along(group.corner) > 0;
  }
  // 180 degrees or more on the side of the workpiece; straight back is an outer corner of 0 degrees.
  static bool is_inner(const Group& group) {
    return group.corner.first_side * Section::cross(group.corner) > 0 || is_straight(group);
  }
  // An offset circle of a negative radius meets nothing.
  static bool offset_circles_exist(const Group& group) {
    if (is_of_lines(group)) return true;
    const Corner& c = Section::in_plane(group);
    if (offset_radius_sign(*c.first, true, c.first_side, *c.offset) < 0) return false;
    return c.second == nullptr || offset_radius_sign(*c.second, false, c.second_side, *c.offset) >= 0;
  }
  // The intersection of the offset tangents, or the prolonged ones at an acute corner.
  void add_outer(Group& group) const {
    if (Section::along(group.corner) >= 0) {
      add(group, HeadKind::tangents_meet);
      return;
    }
    add(group, HeadKind::first_extended);
    add(group, HeadKind::second_extended);
  }
  // An inner corner, and an acute one of lines under 1 degree, starts and ends as type A has it.
  [[nodiscard]] bool is_as_in_type_a(const Group& group) const {
    if (!parameters_.type_b || is_inner(group)) return true;
    return is_of_lines(group) && Section::along(group.corner) < 0 && section().is_under_one_degree(group.corner);
  }
  // False where there is no intersection.
  [[nodiscard]] bool make_ordinary(Group& group) const;
  void make_start_up(Group& group) const;
  void make_cancel(Group& group) const;
  // Where the paths have no point in common: `otherwise`.
  void make_meeting(Group& group, HeadKind meeting, HeadKind otherwise) const {
    const bool meets = Section::cross(group.corner) != 0 && offset_circles_exist(group) && meet(group, meeting);
    if (!meets) set(group, otherwise);
  }
  [[nodiscard]] bool meet(Group& group, HeadKind kind) const {
    group.size = 1;
    group.head[0] = {{}, kind};
    return section().meet(group.corner, kind, group.head[0].vector);
  }
  void drop_small_movements(Group& group) const;
};

template <class Section, class Group>
bool CornerGroups<Section, Group>::make(Group& group, CornerRule rule) const {
  if (group.corner.offset->nearest == 0) {
    group.clear();
    return true;
  }
  if (group.corner.first_side != group.corner.second_side) {
    make_meeting(group, HeadKind::paths_cross, HeadKind::second_normal);
    return true;
  }
  switch (rule) {
    case CornerRule::repeated:
      set(group, HeadKind::first_normal);
      return true;
    case CornerRule::direction:
      make_meeting(group, HeadKind::paths_meet, HeadKind::first_normal);
      return true;
    case CornerRule::start_up:
      make_start_up(group);
      break;
    case CornerRule::cancel:
      make_cancel(group);
      break;
    case CornerRule::ordinary:
      if (!make_ordinary(group)) return false;
      break;
  }
  if (group.size > 1) drop_small_movements(group);
  return true;
}

template <class Section, class Group>
[[gnu::always_inline]] inline bool CornerGroups<Section, Group>::make_ordinary(Group& group) const {
  if (is_straight(group)) {
    set(group, HeadKind::first_normal);
    return true;
  }
  if (is_inner(group)) {
    if (is_of_lines(group)) {
      set(group, HeadKind::tangents_meet);
      return true;
    }
    if (offset_circles_exist(group)) return meet(group, HeadKind::paths_meet);
    // The arc is left to the interference check.
    set(group, HeadKind::first_normal);
    return true;
  }
  group.size = 0;
  if (first_is_arc(group)) add(group, HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(group)) add(group, HeadKind::second_normal);
  return true;
}

template <class Section, class Group>
void CornerGroups<Section, Group>::make_start_up(Group& group) const {
  if (is_as_in_type_a(group)) {
    set(group, HeadKind::second_normal);
    return;
  }
  group.size = 0;
  if (section().starts_with_normal()) add(group, HeadKind::first_normal);
  add_outer(group);
  if (second_is_arc(group)) add(group, HeadKind::second_normal);
}

template <class Section, class Group>
void CornerGroups<Section, Group>::make_cancel(Group& group) const {
  if (is_as_in_type_a(group)) {
    set(group, HeadKind::first_normal);
    return;
  }
  group.size = 0;
  if (first_is_arc(group)) add(group, HeadKind::first_normal);
  add_outer(group);
  if (section().cancels_with_normal()) add(group, HeadKind::second_normal);
}

// No. 5010: a vector near the last one kept is dropped; the first stays.
template <class Section, class Group>
void CornerGroups<Section, Group>::drop_small_movements(Group& group) const {
  if (parameters_.keeps_all) return;
  if (second_is_arc(group) && Section::in_plane(group).second->semicircle) return;
  std::array<bool, 4> keep{true, true, true, true};
  std::size_t last = 0;
  for (std::size_t i = 1; i < group.size; ++i) {
    keep[i] = !section().is_small_movement(group, i, last);
    if (keep[i]) last = i;
  }
  std::uint8_t size = 0;
  for (std::size_t i = 0; i < group.size; ++i)
    if (keep[i]) group.head[size++] = group.head[i];
  group.size = size;
}

}  // namespace toolcomp::fast
