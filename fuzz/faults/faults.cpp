#include "fuzz/faults/faults.h"

#include <vector>

namespace toolcomp::fuzz {
namespace {

// Most faults show in the first few hundred cases.
constexpr std::uint64_t kSoon = 500;

struct Row {
  std::string_view name;
  std::string_view clauses;
  std::uint64_t budget = kSoon;
};

constexpr Row kLength[] = {
    {"g44_as_g43",
     "fanuc.length-offset.type-a fanuc.length-offset.type-b fanuc.length-offset.type-c fanuc.length-offset.replaces"},
    {"offset_accumulates", "fanuc.length-offset.replaces"},
    {"h_modal_under_ofh", "fanuc.length-offset.ofh fanuc.length-offset.ofh-lone-number", 2000},
    {"g49_z_only", "fanuc.length-offset.cancel", 2000},
    {"g49_any_number", "fanuc.length-offset.cancel-three-axes", 10'000},
    {"tal_ignored", "fanuc.length-offset.type-c"},
    {"zero_move_missing", "fanuc.length-offset.move-without-axis-word"},
    {"g53_keeps_offset", "fanuc.length-offset.machine-position-cancels"},
    {"restore_any_axis", "fanuc.length-offset.restored-in-next-block fanuc.length-offset.restored-by-number", 10'000},
    {"restore_in_g40", "fanuc.length-offset.not-restored-with-cutter-code", 20'000},
    {"incremental_from_offset_position", "fanuc.program.incremental"},
    {"inch_not_converted", "fanuc.program.units", 2000},
    {"feed_not_converted", "fanuc.program.units", 5000},
    {"inch_increment", "fanuc.program.least-increments", 10'000},
};

constexpr Row kEdge[] = {
    {"vector_sign", "fanuc.leading-edge.vector"},
    {"above_90_not_reversed", "fanuc.leading-edge.sign"},
    {"own_movement", "fanuc.leading-edge.vector fanuc.leading-edge.kept-along-the-tool"},
    {"radius_of_next_block", "fanuc.leading-edge.vector", 5000},
    {"rotary_order_swapped", "fanuc.tool-direction.of-pose"},
    {"open_range",
     "fanuc.leading-edge.kept-along-the-tool fanuc.leading-edge.start-along-the-tool "
     "fanuc.leading-edge.across-keeps-sense",
     5000},
    {"right_angle_without_history", "fanuc.leading-edge.across-keeps-sense fanuc.leading-edge.near-90"},
    {"second_still_block_recomputed", "fanuc.leading-edge.two-blocks-without-movement", 10'000},
    {"turned_direction_at_still_block", "fanuc.leading-edge.one-block-without-movement", 2000},
    {"no_double_double", "fanuc.leading-edge.kept-along-the-tool fanuc.leading-edge.start-along-the-tool", 40'000},
    {"cancel_keeps_vector", "fanuc.leading-edge.cancel"},
};

constexpr Row kMeasurement[] = {
    {"signal_without_offset",
     "fanuc.length-measurement.signal fanuc.length-measurement.signal-from-the-start "
     "fanuc.length-measurement.rapid-part fanuc.length-measurement.too-late",
     2000},
    {"difference_reversed", "fanuc.length-measurement.value"},
    {"measured_into_geometry", "fanuc.length-measurement.store"},
    {"position_stays_commanded",
     "fanuc.program.incremental fanuc.length-measurement.value fanuc.length-measurement.rapid-part", 5000},
    {"zone_end_excluded", "fanuc.length-measurement.too-late", 2000},
    {"zone_start_excluded", "fanuc.length-measurement.too-early", 2000},
};

constexpr Row kOffset[] = {
    {"g46_as_g45", "fanuc.tool-offset.travel fanuc.tool-offset.arc"},
    {"g47_once", "fanuc.tool-offset.double"},
    {"sign_of_zero_ignored", "fanuc.tool-offset.sign-of-zero", 2000},
    {"absolute_zero_travel_moves", "fanuc.tool-offset.zero-travel-absolute"},
    {"any_arc_is_offset", "fanuc.tool-offset.travel"},
    {"center_not_offset", "fanuc.tool-offset.arc fanuc.tool-offset.arc-form"},
    {"zero_radius_refused", "fanuc.tool-offset.arc-radius", 5000},
    {"shift_lost", ""},
    {"g53_keeps_shift", "fanuc.tool-offset.machine-position", 5000},
    {"tph_ignored", "fanuc.tool-offset.number", 2000},
};

constexpr Row kCutterB[] = {
    {"arc_vector_wrong_side", "fanuc.cutter-b.arc-vector"},
    {"direction_with_code_only", "fanuc.cutter-b.direction-words"},
    {"cancel_without_move", "fanuc.cutter-b.cancel-alone"},
    {"corner_arc_sense", "fanuc.cutter-b.corner-arc-sense fanuc.cutter-b.corner-arc"},
    {"negative_value_same_side", "fanuc.cutter.side"},
    {"arc_radii_dropped", "fanuc.cutter-b.arc-radii"},
    {"no_start_up_after_reference", "fanuc.cutter-b.machine-position fanuc.cutter-b.start-up", 5000},
    {"edited_cutter_value_at_once", "fanuc.cutter-b.vector fanuc.cutter-b.arc-vector", 10'000},
};

constexpr Row kCutterC[] = {
    {"c_reversal_inner", "fanuc.cutter-c.straight-or-reversal"},
    {"c_far_root", "fanuc.cutter-c.line-arc-point fanuc.cutter-c.arc-arc-point fanuc.cutter-c.line-meets-arc", 2000},
    {"c_perpendicular_for_intersection", "fanuc.cutter-c.outer-obtuse"},
    {"c_no_one_degree_rule", "fanuc.cutter-c.under-one-degree", 5000},
    {"c_start_from_own_block", "fanuc.cutter-c.start-up"},
    {"c_cancel_without_perpendicular", "fanuc.cutter-c.cancel", 2000},
    {"c_repeated_ignored", "fanuc.cutter-c.repeated", 2000},
    {"c_two_still_as_one", "fanuc.cutter-c.two-non-motion-blocks"},
    {"c_offset_one_corner_late", "fanuc.cutter-c.value-at-a-corner fanuc.cutter.side", 2000},
    {"c_negative_offset_ignored", "fanuc.cutter.side"},
    {"c_small_movement_one_axis", "fanuc.cutter-c.small-corner-movement", 5000},
    {"c_right_angle_interferes", "fanuc.cutter-c.interference-check fanuc.cutter-c.moving-block", 2'000},
    {"c_negative_radius_unnoticed", "fanuc.cutter-c.interference-radius", 2000},
    {"c_sweep_unchecked", "fanuc.cutter-c.interference-sweep", 5000},
    {"c_arc_after_removal", "fanuc.cutter-c.interference-straightened fanuc.cutter-c.interference-radius", 5000},
    {"c_spiral_as_circle", "fanuc.cutter-c.arc-radii", 2000},
};

constexpr Row kSide[] = {
    {"side_handedness", "fanuc.tool-side.plane"},
    {"side_tool_at_start", "fanuc.tool-side.plane"},
    {"side_turned_tool", "fanuc.tool-side.one-block-without-movement fanuc.tool-side.plane", 5000},
    {"side_reversal_inner", "fanuc.tool-side.straight-or-reversal fanuc.tool-side.outer-acute", 2000},
    {"side_limit_by_length", "fanuc.tool-side.no-movement-limit", 5000},
    {"side_tilt_limit_always_45", "fanuc.tool-side.plane-change-angle fanuc.tool-side.plane-change-alarm", 5000},
    {"side_q2_ignored", "fanuc.tool-side.q2 fanuc.tool-side.along-the-tool fanuc.tool-side.no-movement-limit", 5000},
    {"side_passed_over_keeps",
     "fanuc.tool-side.moving-block fanuc.tool-side.along-the-tool fanuc.tool-side.no-movement-limit "
     "fanuc.tool-side.plane",
     2000},
    {"side_stop_owner", "fanuc.tool-side.stop-point fanuc.tool-side.corner-side"},
};

constexpr Row kTip[] = {
    {"tip_table_sense", "", 500},
    {"tip_second_axis_first", "fanuc.tool-center-point.choice", 2000},
    {"tip_order_ignored", "fanuc.tool-center-point.choice", 5000},
    {"tip_frame_not_frozen", "", 500},
    {"tip_holder_offset_twice", "fanuc.tool-center-point.length fanuc.tool-center-point.block", 500},
    {"tip_lean_backwards", "fanuc.tool-center-point.lean", 2000},
    {"tip_sample_from_the_end", "", 500},
};

// The questions of a block with P1 that its faults may show at.
constexpr std::string_view kPostureBlock =
    "fanuc.tool-posture.no-plane fanuc.tool-posture.great-circle fanuc.tool-posture.at-start "
    "fanuc.tool-posture.at-end fanuc.tool-posture.changed fanuc.tool-posture.refused "
    "fanuc.tool-center-point.inverse fanuc.tool-center-point.parallel-to-the-work-side "
    "fanuc.tool-center-point.reach-toward-the-axis fanuc.tool-center-point.reach-away-from-the-axis";

constexpr Row kPosture[] = {
    {"posture_linear_weights", "fanuc.tool-posture.great-circle fanuc.tool-posture.lift", 500},
    {"posture_mirrored_at_zero", kPostureBlock, 500},
    {"posture_veto_without_half_turn", kPostureBlock, 500},
    {"posture_no_pre_turn", "fanuc.tool-posture.pre-turn", 2000},
    {"posture_default_ignored", "fanuc.tool-posture.default fanuc.tool-posture.great-circle", 5000},
    {"posture_near_by_ends", kPostureBlock, 2000},
};

// Short cuts for usual blocks, each in a section whose blocks take it.
constexpr Row kUsualCutter[] = {
    {"usual_line_acute", "", 2000},
    {"usual_line_unchecked", "fanuc.cutter-c.interference-alarm", 2000},
};
constexpr Row kUsualSide[] = {
    {"usual_side_line_unchecked", "fanuc.cutter-c.interference-alarm", 5000},
    {"usual_side_line_turned_tool", "", 2000},
    {"usual_side_line_feed", "", 5000},
};
constexpr Row kUsualTip[] = {{"usual_pair_limits", "", 5000}};
constexpr Row kUsualPosture[] = {{"usual_posture_near", "", 2000},
                                 {"usual_posture_branch", "fanuc.tool-posture.branch-mismatch", 5000}};

// What the state of a program does shows in the blocks of face milling.
constexpr Row kKlartext[] = {
    {"klartext_reference_stays", "heidenhain.program.reference-point heidenhain.contour.nominal-tip", 5000},
    {"klartext_row_survives_tool_call", "", 5000},
    {"klartext_table_in_inches", "", 2000},
    {"klartext_rotary_order", "heidenhain.program.direction-of-rotary-axes", 2000},
};

constexpr Row kFace[] = {
    {"face_tip_along_normal", "heidenhain.face.effective-tip"},
    {"face_radius_delta_ignored", "heidenhain.tool.ring-change"},
    {"face_jump_unnoticed", "heidenhain.face.contact-to-flat heidenhain.face.contact-jump", 2000},
    {"face_deviation_steps", "heidenhain.face.contact-point heidenhain.face.effective-tip", 2000},
};

constexpr Row kPeripheral[] = {
    {"peripheral_sides_exchanged", "heidenhain.peripheral.side heidenhain.peripheral.applies"},
    {"peripheral_own_direction_at_corner", "heidenhain.peripheral.mitre", 2000},
    {"peripheral_tool_of_next_block", "heidenhain.peripheral.mitre heidenhain.peripheral.first-block", 2000},
};

constexpr Row kContour[] = {
    {"contour_nominal_corner", "heidenhain.contour.mode heidenhain.contour.face"},
    {"contour_reference_counts", "heidenhain.contour.reference-ignored", 2000},
};

struct Section {
  std::string_view name;
  std::span<const Row> rows;
};
constexpr Section kSections[] = {
    {"fanuc/tool-length-offset", kLength},
    {"fanuc/leading-edge-offset", kEdge},
    {"fanuc/tool-length-measurement", kMeasurement},
    {"fanuc/tool-offset", kOffset},
    {"fanuc/cutter-compensation-b", kCutterB},
    {"fanuc/cutter-compensation-c", kCutterC},
    {"fanuc/tool-side-compensation", kSide},
    {"fanuc/tool-center-point-control", kTip},
    {"fanuc/tool-posture-control", kPosture},
    {"fanuc/cutter-compensation-c", kUsualCutter},
    {"fanuc/tool-side-compensation", kUsualSide},
    {"fanuc/tool-center-point-control", kUsualTip},
    {"fanuc/tool-posture-control", kUsualPosture},
    {"heidenhain/face-milling", kKlartext},
    {"heidenhain/face-milling", kFace},
    {"heidenhain/peripheral-milling", kPeripheral},
    {"heidenhain/programmed-contour", kContour},
};

std::vector<SeededFault> all() {
  std::vector<SeededFault> faults;
  for (const Section& section : kSections)
    for (const Row& row : section.rows) faults.push_back({row.name, section.name, row.clauses, row.budget});
  return faults;
}

}  // namespace

std::span<const SeededFault> seeded_faults() {
  static const std::vector<SeededFault> faults = all();
  return faults;
}

}  // namespace toolcomp::fuzz
