// SPDX-License-Identifier: Apache-2.0
// The alarms of the control: number and text.
#pragma once

namespace toolcomp::fast {

struct Alarm {
  const char* number = nullptr;  // nullptr: no alarm
  const char* message = "";
  explicit operator bool() const { return number != nullptr; }
};

namespace alarm {

inline constexpr Alarm kNone{};
inline constexpr Alarm kUnknownCode{"PS0010", "there is no such G code"};
// `text`: of a code that has a name; else nullptr.
constexpr Alarm unknown_code(const char* text) { return text == nullptr ? kUnknownCode : Alarm{"PS0010", text}; }
inline constexpr Alarm kUnknownList{"PS0010", "this use of G10 is not available"};
inline constexpr Alarm kLengthAxes{"PS0015", "G49 with three or more offset axes"};
inline constexpr Alarm kArcRadius{"PS0023", "arc radius or centre that cannot be"};
inline constexpr Alarm kLengthAxisMissing{"PS0027", "no axis, or a second axis, for tool length offset type C"};
inline constexpr Alarm kPlaneAxis{"PS0028", "the machine lacks an axis of the plane"};
inline constexpr Alarm kOffsetValue{"PS0029", "offset value too large"};
inline constexpr Alarm kOffsetNumber{"PS0030", "offset number out of range"};
inline constexpr Alarm kSystemNumber{"PS0030", "G54.1: there is no workpiece system of this number"};
inline constexpr Alarm kOriginNumber{"PS0031", "G10: there is no workpiece system of this number"};
inline constexpr Alarm kWriteNumber{"PS0031", "G10: offset number out of range"};
inline constexpr Alarm kWriteValue{"PS0032", "G10: offset value out of range"};
inline constexpr Alarm kNoIntersection{"PS0033", "no intersection in cutter compensation"};
inline constexpr Alarm kArcAtStartOrCancel{"PS0034", "arc where cutter compensation starts or ends"};
inline constexpr Alarm kCornerArc{"PS0035", "G39 outside cutter compensation, or without a direction"};
inline constexpr Alarm kMeasurementInCutter{"PS0036", "G37 in cutter compensation"};
inline constexpr Alarm kPlaneChange{"PS0037", "change of plane in cutter compensation"};
inline constexpr Alarm kArcCenter{"PS0038", "arc centre in its start or end"};
inline constexpr Alarm kInterference{"PS0041", "interference in cutter compensation"};
inline constexpr Alarm kToolOffsetInCutter{"PS0042", "G45 to G48 in cutter compensation"};
inline constexpr Alarm kReferenceNumber{"PS0046", "G30: P must be 2, 3 or 4"};
inline constexpr Alarm kNoSignal{"PS0080", "G37: no signal where it is expected"};
inline constexpr Alarm kMeasurementNumberZero{"PS0081", "G37 without an H number"};
inline constexpr Alarm kMeasurementNumberInBlock{"PS0082", "H in the block with G37"};
inline constexpr Alarm kMeasurementAxis{"PS0083", "G37 without exactly one axis, or under G91"};
inline constexpr Alarm kLeadingEdgeFormat{"PS5406", "movement or stop in the G41.3 or G40 block"};
inline constexpr Alarm kLeadingEdgeCommand{"PS5407", "command not possible in G41.3, or no movement after it"};
inline constexpr Alarm kLeadingEdgeStart{"PS5408", "G41.3 cannot start here"};
inline constexpr Alarm kToolDirection{"PS5421", "rotary word or zero direction under G43.5"};
inline constexpr Alarm kTipControlWord{"PS5421", "P of G43.4 or G43.5 must be 0 or 1"};
inline constexpr Alarm kDirectionAtStart{"PS5421", "I J K in the G43.5 block on a machine with a table axis"};
inline constexpr Alarm kTipControlArc{"PS5421", "arc under G43.5 without R, or rotation alone in an arc"};
inline constexpr Alarm kTableTurnedInArc{"PS5421", "a table axis not normal to the plane of the arc has turned"};
inline constexpr Alarm kSingularPosture{"PS5421", "the end posture cannot be changed near a singular posture"};
inline constexpr Alarm kTipControl{"PS5459", "G43.4 or G43.5 is not possible on this machine"};
inline constexpr Alarm kRotaryLimits{"PS5459", "a lower limit of a rotary axis is above the upper one"};
inline constexpr Alarm kUnreachable{"PS5459", "the tool direction cannot be reached in the range of the rotary axes"};
inline constexpr Alarm kRotaryWord{"PS5460", "rotary word under G43.5 in tool side compensation"};
inline constexpr Alarm kForbiddenInCompensation{"FORBIDDEN_IN_3D_COMPENSATION",
                                                "command not allowed in the G41.2, G42.2 or G41.3 mode"};
inline constexpr Alarm kToolSideMode{"TOOL_SIDE_MODE", "G41.2 and G42.2 under G43.5, or G41.6 and G42.6 without it"};
inline constexpr Alarm kTypeCFormat{"TYPE_C_FORMAT", "movement where type C starts or ends, or none behind its start"};
inline constexpr Alarm kTreatment{"Q_FORMAT", "Q must be 1, 2 or 3"};
inline constexpr Alarm kPlaneChangeInterference{"PS0041", "interference where the compensation plane changes"};
inline constexpr Alarm kForbiddenInCutterCompensation{"FORBIDDEN_IN_CUTTER_COMPENSATION",
                                                      "command not allowed in cutter compensation"};
inline constexpr Alarm kDirectionChangeAtStart{"DIR_CHANGE_AT_STARTUP",
                                               "change of side in the start-up block or the one after it"};
inline constexpr Alarm kForbiddenUnderDirection{"FORBIDDEN_UNDER_TOOL_DIRECTION",
                                                "command not allowed under G43.4 or G43.5"};
inline constexpr Alarm kLengthExclusion{"LENGTH_OFFSET_EXCLUSION",
                                        "length offset and G43.4 or G43.5 exclude each other"};
inline constexpr Alarm kDirectionFormat{"TOOL_DIRECTION_FORMAT", "G43.4 or G43.5, or its G49, where it may not stand"};
inline constexpr Alarm kCompensationInWorkpiece{
    "COMPENSATION_IN_WORKPIECE_SYSTEM",
    "three-dimensional compensation with 19696#5 = 1 on a machine with a table axis"};
inline constexpr Alarm kArcInCompensation{"PS5461", "an arc in tool side compensation on a mixed machine"};
inline constexpr Alarm kArcWithTableTurned{"ARC_WITH_TABLE_TURNED",
                                           "an arc with 19696#5 = 1 while a table axis turns or has turned"};
inline constexpr Alarm kMeasurementFormat{"MEASUREMENT_FORMAT", "G43, G44 or G49 in the block with G37"};
inline constexpr Alarm kMeasurementParameters{"MEASUREMENT_PARAMETERS", "6241, 6251 and 6254 do not fit"};
inline constexpr Alarm kToolOffsetLength{"G45_LENGTH_OFFSET",
                                         "G45 to G48 with an H number while a length offset is on"};
inline constexpr Alarm kToolOffsetArc{"G45_ARC", "G45 to G48 with an arc that is no quarter or three-quarter circle"};
inline constexpr Alarm kRange{"POSITION_RANGE", "position beyond 3e17"};

}  // namespace alarm

}  // namespace toolcomp::fast
