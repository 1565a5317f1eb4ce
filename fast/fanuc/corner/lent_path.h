// SPDX-License-Identifier: Apache-2.0
// What a section lends to its short cut of paths (usual_paths.h), and takes back: the same path in both forms.
#pragma once

#include <array>
#include <cstddef>

#include "fast/basis/event.h"
#include "fast/fanuc/corner/usual_corner.h"
#include "fast/geometry/corner.h"
#include "fast/geometry/path.h"

namespace toolcomp::fast {

// False: it is no usual one.
[[nodiscard]] bool set_usual_path(UsualPath& to, const PlanePath& path);
void set_plane_path(PlanePath& to, const UsualPath& path);

// Of an arc behind a corner that was made with its own side and offset: the last vector there, of this kind, ends on
// its offset circle.
[[nodiscard]] bool is_on_circle(const PlanePath& arc, const Corner& corner, HeadKind kind);
// Beside the axes of the plane, all are sent where they were in the event before.
[[nodiscard]] bool moves_in_plane_only(const std::array<std::size_t, 2>& axis, const Event& before, const Event& event);

}  // namespace toolcomp::fast
