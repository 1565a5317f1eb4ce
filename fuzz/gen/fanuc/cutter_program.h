// SPDX-License-Identifier: Apache-2.0
// What the generators of cutter compensation B and C have in common.
#pragma once

#include <string>

#include "fuzz/gen/fanuc/contour.h"
#include "fuzz/gen/fanuc/program_writer.h"

namespace toolcomp::fuzz {

// Movements in a plane as blocks, offset numbers, and blocks that do not move in the plane; the types add how
// compensation starts, what happens inside, and how it ends.
class CutterProgram {
 public:
  CutterProgram(Choices& choose, spec::Case& c);
  CutterProgram(const CutterProgram&) = delete;
  CutterProgram& operator=(const CutterProgram&) = delete;

  // Start-up, inside, cancel, again and again until about so many blocks are written. In `cancels` of a hundred cycles
  // the compensation is cancelled; without a cancel the next cycle, or the end, finds it active.
  std::string program(std::uint32_t blocks, std::uint64_t cancels);

 protected:
  ~CutterProgram() = default;

  // What G39 does not take into its block, each an alarm by itself.
  static constexpr const char* kNotWithCornerArc[] = {"G40", "G41", "G42", "D1", "D2", "D0", "X5. Y5. Z5.", "G28 X0"};

  virtual void start_up() = 0;
  virtual void inside() = 0;
  virtual void cancel() = 0;

  // Plane, mode, feed, where the program starts.
  void preamble();

  // The words of a movement, with the code of its type where that changes; the block is not ended.
  void segment(const Segment& s);
  void line();
  void movement();
  // A movement and the end of its block; sometimes with a word that changes nothing for the compensation.
  void block(const Segment& s);
  void blocks(const Segments& all);

  // D (or H, where that counts too) with a number that has an entry; the contour takes its value.
  void number();
  void number(std::int64_t n);
  // The side of the path, by the code in force: +1 for G41.
  void side(int sign);
  [[nodiscard]] int side() const { return side_; }
  void side_word(int sign);

  // One block without movement in the plane.
  void still_block();
  // An axis word of the plane with zero travel.
  void zero_travel();
  // I J, K I or J K as a direction from the end point: any, zero, or one that lies special to the path.
  void direction_words();
  void direction_words(PlaneCounts d);
  // G10 that changes the offset in force, or another.
  void change_memory();
  // G53, G28, G30, G29 with axes of the plane and others.
  void machine_block();
  void switch_mode();
  void normal_travel();

  [[nodiscard]] char first() const { return letters_[0]; }
  [[nodiscard]] char second() const { return letters_[1]; }
  [[nodiscard]] char normal() const { return letters_[2]; }
  void plane(std::size_t which);

  Choices& choose_;      // NOLINT(*-non-private-member-variables-in-classes): for the programs made from this
  spec::Case& case_;     // NOLINT(*-non-private-member-variables-in-classes)
  ProgramWriter write_;  // NOLINT(*-non-private-member-variables-in-classes)
  Contour contour_;      // NOLINT(*-non-private-member-variables-in-classes)

 private:
  void take_offset();
  // Counts of a setup's table, 0 where the axis is not in it.
  [[nodiscard]] std::int64_t table_value(const spec::AxisTable& table, char letter) const;
  // Workpiece coordinate of a reference point under G54.
  [[nodiscard]] std::int64_t reference(int point, char letter) const;
  void motion(std::string_view code);

  std::string letters_ = "XYZ";
  std::string centers_ = "IJK";
  std::string motion_;
  std::int64_t number_ = 0;
  int side_ = 1;
};

}  // namespace toolcomp::fuzz
