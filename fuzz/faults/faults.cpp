#include "fuzz/faults/faults.h"

namespace toolcomp::fuzz {
namespace {

constexpr std::string_view kLength = "fanuc/tool-length-offset";
constexpr std::string_view kMeasurement = "fanuc/tool-length-measurement";
constexpr std::string_view kOffset = "fanuc/tool-offset";
constexpr std::string_view kCutterB = "fanuc/cutter-compensation-b";
constexpr std::string_view kCutterC = "fanuc/cutter-compensation-c";
constexpr std::string_view kSide = "fanuc/tool-side-compensation";
constexpr std::string_view kEdge = "fanuc/leading-edge-offset";

constexpr SeededFault kFaults[] = {
    {"g44_as_g43", kLength,
     "fanuc.length-offset.type-a fanuc.length-offset.type-b fanuc.length-offset.type-c fanuc.length-offset.replaces",
     500},
    {"offset_accumulates", kLength, "fanuc.length-offset.replaces", 500},
    {"h_modal_under_ofh", kLength, "fanuc.length-offset.ofh fanuc.length-offset.ofh-lone-number", 2000},
    {"g49_z_only", kLength, "fanuc.length-offset.cancel", 2000},
    {"g49_any_number", kLength, "fanuc.length-offset.cancel-three-axes", 10'000},
    {"tal_ignored", kLength, "fanuc.length-offset.type-c", 500},
    {"zero_move_missing", kLength, "fanuc.length-offset.move-without-axis-word", 500},
    {"g53_keeps_offset", kLength, "fanuc.length-offset.machine-position-cancels", 500},
    {"restore_any_axis", kLength, "fanuc.length-offset.restored-in-next-block fanuc.length-offset.restored-by-number",
     10'000},
    {"restore_in_g40", kLength, "fanuc.length-offset.not-restored-with-cutter-code", 20'000},
    {"incremental_from_offset_position", kLength, "fanuc.program.incremental", 500},
    {"inch_not_converted", kLength, "fanuc.program.units", 2000},
    {"feed_not_converted", kLength, "fanuc.program.units", 5000},
    {"inch_increment", kLength, "fanuc.program.least-increments", 10'000},
    {"vector_sign", kEdge, "fanuc.leading-edge.vector", 500},
    {"above_90_not_reversed", kEdge, "fanuc.leading-edge.sign", 500},
    {"own_movement", kEdge, "fanuc.leading-edge.vector fanuc.leading-edge.kept-along-the-tool", 500},
    {"radius_of_next_block", kEdge, "fanuc.leading-edge.vector", 5000},
    {"rotary_order_swapped", kEdge, "fanuc.tool-direction.of-pose", 500},
    {"open_range", kEdge,
     "fanuc.leading-edge.kept-along-the-tool fanuc.leading-edge.start-along-the-tool "
     "fanuc.leading-edge.across-keeps-sense",
     5000},
    {"right_angle_without_history", kEdge, "fanuc.leading-edge.across-keeps-sense fanuc.leading-edge.near-90", 500},
    {"second_still_block_recomputed", kEdge, "fanuc.leading-edge.two-blocks-without-movement", 10'000},
    {"turned_direction_at_still_block", kEdge, "fanuc.leading-edge.one-block-without-movement", 2000},
    {"no_double_double", kEdge, "fanuc.leading-edge.kept-along-the-tool fanuc.leading-edge.start-along-the-tool",
     40'000},
    {"cancel_keeps_vector", kEdge, "fanuc.leading-edge.cancel", 500},
    {"signal_without_offset", kMeasurement,
     "fanuc.length-measurement.signal fanuc.length-measurement.signal-from-the-start "
     "fanuc.length-measurement.rapid-part fanuc.length-measurement.too-late",
     2000},
    {"difference_reversed", kMeasurement, "fanuc.length-measurement.value", 500},
    {"measured_into_geometry", kMeasurement, "fanuc.length-measurement.store", 500},
    {"position_stays_commanded", kMeasurement,
     "fanuc.program.incremental fanuc.length-measurement.value fanuc.length-measurement.rapid-part", 5000},
    {"g46_as_g45", kOffset, "fanuc.tool-offset.travel fanuc.tool-offset.arc", 500},
    {"g47_once", kOffset, "fanuc.tool-offset.double", 500},
    {"sign_of_zero_ignored", kOffset, "fanuc.tool-offset.sign-of-zero", 2000},
    {"absolute_zero_travel_moves", kOffset, "fanuc.tool-offset.zero-travel-absolute", 500},
    {"any_arc_is_offset", kOffset, "fanuc.tool-offset.travel", 500},
    {"center_not_offset", kOffset, "fanuc.tool-offset.arc fanuc.tool-offset.arc-form", 500},
    {"shift_lost", kOffset, "", 500},
    {"g53_keeps_shift", kOffset, "fanuc.tool-offset.machine-position", 5000},
    {"tph_ignored", kOffset, "fanuc.tool-offset.number", 2000},
    {"arc_vector_wrong_side", kCutterB, "fanuc.cutter-b.arc-vector", 500},
    {"direction_with_code_only", kCutterB, "fanuc.cutter-b.direction-words", 500},
    {"cancel_without_move", kCutterB, "fanuc.cutter-b.cancel-alone", 500},
    {"corner_arc_sense", kCutterB, "fanuc.cutter-b.corner-arc-sense fanuc.cutter-b.corner-arc", 500},
    {"negative_value_same_side", kCutterB, "fanuc.cutter.side", 500},
    {"arc_radii_dropped", kCutterB, "fanuc.cutter-b.arc-radii", 500},
    {"no_start_up_after_reference", kCutterB, "fanuc.cutter-b.machine-position fanuc.cutter-b.start-up", 5000},
    {"edited_cutter_value_at_once", kCutterB, "fanuc.cutter-b.vector fanuc.cutter-b.arc-vector", 10'000},
    {"c_reversal_inner", kCutterC, "fanuc.cutter-c.straight-or-reversal", 500},
    {"c_far_root", kCutterC, "fanuc.cutter-c.line-arc-point fanuc.cutter-c.arc-arc-point fanuc.cutter-c.line-meets-arc",
     2000},
    {"c_perpendicular_for_intersection", kCutterC, "fanuc.cutter-c.outer-obtuse", 500},
    {"c_no_one_degree_rule", kCutterC, "fanuc.cutter-c.under-one-degree", 5000},
    {"c_start_from_own_block", kCutterC, "fanuc.cutter-c.start-up", 500},
    {"c_cancel_without_perpendicular", kCutterC, "fanuc.cutter-c.cancel", 2000},
    {"c_repeated_ignored", kCutterC, "fanuc.cutter-c.repeated", 2000},
    {"c_two_still_as_one", kCutterC, "fanuc.cutter-c.two-non-motion-blocks", 500},
    {"c_offset_one_corner_late", kCutterC, "fanuc.cutter-c.value-at-a-corner fanuc.cutter.side", 2000},
    {"c_negative_offset_ignored", kCutterC, "fanuc.cutter.side", 500},
    {"c_small_movement_one_axis", kCutterC, "fanuc.cutter-c.small-corner-movement", 5000},
    {"c_right_angle_interferes", kCutterC, "fanuc.cutter-c.interference-check fanuc.cutter-c.moving-block", 20'000},
    {"c_negative_radius_unnoticed", kCutterC, "fanuc.cutter-c.interference-radius", 2000},
    {"c_sweep_unchecked", kCutterC, "fanuc.cutter-c.interference-sweep", 5000},
    {"c_arc_after_removal", kCutterC, "fanuc.cutter-c.interference-straightened fanuc.cutter-c.interference-radius",
     5000},
    {"c_spiral_as_circle", kCutterC, "fanuc.cutter-c.arc-radii", 2000},
    {"side_handedness", kSide, "fanuc.tool-side.plane", 500},
    {"side_tool_at_start", kSide, "fanuc.tool-side.plane", 500},
    {"side_turned_tool", kSide, "fanuc.tool-side.one-block-without-movement fanuc.tool-side.plane", 5000},
    {"side_reversal_inner", kSide, "fanuc.tool-side.straight-or-reversal fanuc.tool-side.outer-acute", 2000},
    {"side_limit_by_length", kSide, "fanuc.tool-side.no-movement-limit", 5000},
    {"side_tilt_limit_always_45", kSide, "fanuc.tool-side.plane-change-angle fanuc.tool-side.plane-change-alarm", 5000},
    {"side_q2_ignored", kSide, "fanuc.tool-side.q2 fanuc.tool-side.along-the-tool fanuc.tool-side.no-movement-limit",
     5000},
    {"side_stop_owner", kSide, "fanuc.tool-side.stop-point fanuc.tool-side.corner-side", 500},
};

}  // namespace

std::span<const SeededFault> seeded_faults() { return kFaults; }

}  // namespace toolcomp::fuzz
