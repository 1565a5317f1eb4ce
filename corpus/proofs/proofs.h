// Golden vectors as lemmas of Coq: what the formal specification says about them, proved without the model.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::corpus {

// One lemma; its name says vector and line.
struct Lemma {
  std::string name;
  std::string text;           // statement and proof
  bool by_intervals = false;  // dear: rotary axes and roots; else by computation over Q
};

// What can be said about one vector by the formal specification of its section; nothing where it uses more than that
// covers (alarms, G10, changes of units, …: the functions below say what). Everything is read from setup, program and
// expected events: nothing is taken from the engines.
//   leading edge    a move whose vector is made of the next movement: the class of the angle, the sense, and that the
//                   recorded point is the programmed point plus VC to within its radius, or exactly;
//   length offset   a whole program of G43 G44 G49 H and straight moves, types A and B: every position of the axes;
//   G37             the first measurement of a program: where it ends, and the value written or the alarm;
//   G45 to G48      a block on one axis: the programmed and the actual position after it;
//   cutter B        a straight block in the XY plane: that the recorded point is the programmed one plus the vector;
//   cutter C        a corner of two lines in the offset mode, XY plane: its class, and that the recorded heads are
//   those
//                   of the class, exactly where the lengths of both lines are rational;
//   tool side       a corner of two lines in the mode: its class in the compensation plane, and that the recorded heads
//                   are those of the class, exactly where the lengths in it are rational;
//   tip control     a direction by I J K: that the recorded tool axis is its unit vector, that the recorded rotary
//                   positions point along it, and on a head the recorded control point;
//   posture         the middle of a block with P1: that the recorded tool axis lies in the plane, half way;
//   face milling    a block with a normal: that the recorded point is the tip of the effective tool;
//   flanks          a block under RL or RR: that the recorded point is the tip beside the end point, or at the mitre;
//   contour         the same under IS CONTOUR.
std::vector<Lemma> leading_edge_lemmas(const spec::Case& c);
std::vector<Lemma> length_offset_lemmas(const spec::Case& c);
std::vector<Lemma> length_measurement_lemmas(const spec::Case& c);
std::vector<Lemma> tool_offset_lemmas(const spec::Case& c);
std::vector<Lemma> cutter_b_lemmas(const spec::Case& c);
std::vector<Lemma> cutter_compensation_c_lemmas(const spec::Case& c);
std::vector<Lemma> tool_side_lemmas(const spec::Case& c);
std::vector<Lemma> tool_center_point_lemmas(const spec::Case& c);
std::vector<Lemma> tool_posture_lemmas(const spec::Case& c);
std::vector<Lemma> face_milling_lemmas(const spec::Case& c);
std::vector<Lemma> peripheral_milling_lemmas(const spec::Case& c);
std::vector<Lemma> programmed_contour_lemmas(const spec::Case& c);

struct ProofOptions {
  std::size_t computed = 40;  // lemmas a section, at most
  std::size_t intervals = 8;  // the same, by intervals
  std::size_t a_vector = 2;   // of one vector
};

struct ProofFile {
  std::filesystem::path file;
  std::size_t vectors = 0;
  std::size_t lemmas = 0;
};

// Writes one Coq file a section into `output`, for proofs/check to prove. Sections without a formal specification have
// none.
std::vector<ProofFile> write_proofs(const std::filesystem::path& corpus, const std::filesystem::path& output,
                                    const ProofOptions& options = {});

}  // namespace toolcomp::corpus
