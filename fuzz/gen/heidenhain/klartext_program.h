// SPDX-License-Identifier: Apache-2.0
// Klartext programs of 3D tool compensation, for the generators of its sections.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/gen/heidenhain/klartext_writer.h"
#include "fuzz/gen/heidenhain/space_vectors.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz {

// How often what is written, of 100.
struct ProgramWeights {
  int face = 0;               // LN blocks with a normal
  int beside = 0;             // stretches with RL or RR
  int plain = 0;              // L and LN without compensation
  int statements = 0;         // blocks that move nothing
  std::uint64_t contour = 0;  // programs that begin under PROG PATH IS CONTOUR
};

// A program of `blocks` motion blocks or a few more.
class KlartextProgram {
 public:
  KlartextProgram(Choices& choose, const spec::Setup& setup, const ProgramWeights& weights);
  std::string text(std::uint32_t blocks);

 private:
  enum class Side : std::uint8_t { none, left, right };

  void head();
  void tail();
  void motion();

  // Blocks that move nothing.
  void statement();
  void tool_call();
  void call_without_tool();
  void correction();
  void tcpm_on();
  void tcpm_off();
  void path(bool contour);
  void cycle();
  void other();
  void functions_alone();
  void delta(std::string_view key, std::int64_t size);
  void radius_deltas(std::int64_t r, std::int64_t r2, bool with_r, bool with_r2);

  // Motion blocks.
  void face();
  void stretch();
  void stretch_block(bool first);
  void plain();
  void leave_side(std::uint64_t stays);
  void mistake();
  void out_of_scope();
  void approach();

  // Drilling cycles (klartext_holes.cpp).
  void holes();
  void rest_before_holes();
  void define_cycle();
  void choose_levels();
  void cycle_word(std::string_view parameter, std::int64_t count, std::string_view meaning);
  void change_cycle();
  void assign_level();
  void shift_along_the_tool();
  void retract();
  void hole();
  void cross_the_tool();
  void refused_call();

  void position_words(std::string_view prefix, bool all);
  void line_words(std::uint64_t rotary);
  void rotary_words();
  void vector_words(char kind, const VectorWords& v);
  void radius_word(Side side);
  void feed();
  void end_motion();
  void travel();
  [[nodiscard]] VectorWords tool_axis() const;
  [[nodiscard]] VectorWords tool_vector();
  // Radii of the tool in force and what is added to them, mm.
  struct Radii {
    double r = 0;
    double r2 = 0;
    double off_r = 0;
    double off_r2 = 0;
  };
  [[nodiscard]] Radii radii() const;
  [[nodiscard]] bool is_oversize() const;
  [[nodiscard]] bool deviates() const;

  Choices& choose_;
  const spec::Setup& setup_;
  ProgramWeights weights_;
  KlartextWriter write_;
  int decimals_ = 4;
  std::int64_t one_ = 10'000;
  bool inch_ = false;
  std::uint32_t motions_ = 0;
  bool drills_ = false;   // the program has drilling cycles
  bool defined_ = false;  // one was
  bool lines_of_cycle_ = true;
  // Of the cycle, as far as the generator knows.
  struct Levels {
    std::int64_t clearance = 0;
    std::int64_t depth = 0;
    std::int64_t surface = 0;
    std::int64_t second = 0;
  };
  Levels levels_;

  // Where the program stands, as far as the generator knows.
  std::array<std::int64_t, 3> at_{};
  std::array<std::int64_t, 3> step_{};  // the travel before
  std::size_t tool_ = 0;
  char axis_ = 'Z';
  bool tcpm_ = false;
  bool contour_ = false;
  bool oversize_permitted_ = false;
  Side side_ = Side::none;
  double call_r_ = 0;  // mm
  double call_r2_ = 0;
  std::uint32_t row_ = 0;  // of the corrections; 0: none
  VectorWords tool_vector_{{0, 0, 1}, 0};
  VectorWords normal_{{0, 0, 1}, 0};
  bool had_normal_ = false;
};

}  // namespace toolcomp::fuzz
