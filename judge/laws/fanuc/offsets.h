// SPDX-License-Identifier: Apache-2.0
// Laws of chapter 14's offsets: tool length offset, tool offset G45 to G48, tool length measurement G37.
#pragma once

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// The axes go to the point plus the offset: a block with G43 or G44 and H moves the axis of its offset by +H or -H, and
// without a length offset in force (G49) the axes go to the point itself. Chapter 14, 14.1.1 (effect, cancel). Up to
// the first G10 or G37 (the memory changes); not in programs with G28, G29, G30 or G53.
void length_offset(const FanucScene& scene, Holding& holding);

// The length offset stays what it was from one block to the next unless a block says otherwise (G43, G44, G49, H).
// Chapter 14, 14.1.1 (modal). Exempt as above, and wherever coordinates may be renamed or G43.4, G43.5 are in force;
// of holes between two moves `hole-axes` asks it.
void length_offset_stays(const FanucScene& scene, Holding& holding);

// With 5006#6 = 1 the length offset moves nothing: under G91 the axes go by the words of the block, whatever G43, G44,
// G49 and H stand in it or before it. B-63943EN-1/02 p.1654. Words with a decimal point, in the units of the setup. Not
// in programs with compensation, nor where a block since the last move drills, goes elsewhere or renames coordinates in
// another way (G10, G28 to G30, G37, G39, G43.4, G43.5, G45 to G48, G52 to G59, G92).
void by_the_words_alone(const FanucScene& scene, Holding& holding);

// The shift between programmed and actual position grows in every commanded axis by the offset, once or twice, with the
// sign of the travel; nothing else changes it. Chapter 14, 14.3, table 14.1. Not for the first block, nor the first
// behind a hole (its travel is not known), with 5001#2 or 5001#5 = 1 (H may be the number), nor in programs with
// compensation, G10, G28 to G30, G37, G53, G92.
void signed_sums(const FanucScene& scene, Holding& holding);

// The new offset is the old one plus where the signal came, less where it was commanded. Chapter 14, 14.2. Not with
// G10.
void measured_difference(const FanucScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws
