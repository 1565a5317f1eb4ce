// Wrong clauses that both engines follow alike. Each engine stays as it is: a program or a setup is altered behind its
// back, so both run the wrong thing and agree, and the events are held against the case as it was written. Only a law
// can find it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/oracle/trial.h"

namespace toolcomp::fuzz {

struct WrongClause {
  std::string_view name;
  std::string_view section;  // whose directed generator must find it
  std::string_view law;      // that must find it first
  std::uint64_t budget;      // executions, fresh cases of one seed
  // The case that both engines run instead; nothing: the case itself.
  spec::Case (*altered)(const spec::Case&);
  // What is wrong in the events of both; nothing: the altered case says it all.
  void (*events)(const spec::Case&, std::vector<model::Event>&);
};

// Found by these laws after so many executions from seed 1 (tests/harness/laws.cpp prints them).
//
//   side_along_the_former_tool   perpendicular-to-the-tool    the clause as it stood: a block displaced along the tool
//   of
//                                                             the block before keeps the vector although it turns the
//                                                             tool
//   side_negative_value          beside-the-line-before       a negative D does not exchange the sides
//   edge_sense                   leading-edge-vector          forward for backward
//   length_44_as_43              length-offset
//   measured_reversed            measured-difference          commanded less reached
//   offset_46_as_45              signed-sums
//   cutter_b_negative_value      normal-of-the-block          as above
//   cutter_c_negative_value      beside-the-line-before       as above
//   tip_without_holder_offset    tip-of-the-axes              19666 ignored
//   tip_sense                    axis-of-the-positions        19689 reversed
//   tip_leans_backward           commanded-direction          Q away from the travel
//   posture_conventional         great-circle                 P1 run as P0
//   face_radius_delta            touches-the-contact-plane    DR of the tool table ignored
//   peripheral_sides             cylinder-beside-the-line     RL and RR exchanged
std::span<const WrongClause> wrong_clauses();

// The case through both engines with the wrong clause, judged, and held against the laws.
Trial try_wrong(const WrongClause& wrong, const spec::Case& c);

}  // namespace toolcomp::fuzz
