// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "corpus/examples.h"

namespace toolcomp::corpus {

std::span<const ExampleFile> example_files() {
  static const std::array kFiles{
      ExampleFile{"fanuc/tool-length-offset", "examples", tool_length_offset_examples()},
      ExampleFile{"fanuc/tool-length-offset", "rules", tool_length_offset_rules()},
      ExampleFile{"fanuc/tool-length-measurement", "examples", tool_length_measurement_examples()},
      ExampleFile{"fanuc/tool-length-measurement", "rules", tool_length_measurement_rules()},
      ExampleFile{"fanuc/tool-offset", "examples", tool_offset_examples()},
      ExampleFile{"fanuc/tool-offset", "rules", tool_offset_rules()},
      ExampleFile{"fanuc/canned-cycle", "examples", canned_cycle_examples()},
      ExampleFile{"fanuc/cutter-compensation-b", "examples", cutter_compensation_b_examples()},
      ExampleFile{"fanuc/cutter-compensation-b", "rules", cutter_compensation_b_rules()},
      ExampleFile{"fanuc/cutter-compensation-c", "examples", cutter_compensation_c_examples()},
      ExampleFile{"fanuc/cutter-compensation-c", "examples-corners", cutter_compensation_c_corners()},
      ExampleFile{"fanuc/cutter-compensation-c", "examples-checks", cutter_compensation_c_checks()},
      ExampleFile{"fanuc/cutter-compensation-c", "rules", cutter_compensation_c_rules()},
      ExampleFile{"fanuc/tool-side-compensation", "examples", tool_side_compensation_examples()},
      ExampleFile{"fanuc/tool-side-compensation", "rules", tool_side_compensation_rules()},
      ExampleFile{"fanuc/leading-edge-offset", "examples", leading_edge_offset_examples()},
      ExampleFile{"fanuc/leading-edge-offset", "rules", leading_edge_offset_rules()},
      ExampleFile{"fanuc/tool-center-point-control", "examples", tool_center_point_control_examples()},
      ExampleFile{"fanuc/tool-center-point-control", "rules", tool_center_point_control_rules()},
      ExampleFile{"fanuc/tool-posture-control", "examples", tool_posture_control_examples()},
      ExampleFile{"fanuc/tool-posture-control", "rules", tool_posture_control_rules()},
      ExampleFile{"heidenhain/face-milling", "examples", face_milling_examples()},
      ExampleFile{"heidenhain/face-milling", "rules", face_milling_rules()},
      ExampleFile{"heidenhain/face-milling", "klartext", klartext_examples()},
      ExampleFile{"heidenhain/face-milling", "calls", klartext_calls()},
      ExampleFile{"heidenhain/face-milling", "retractions", klartext_retractions()},
      ExampleFile{"heidenhain/face-milling", "drilling", klartext_drilling()},
      ExampleFile{"heidenhain/peripheral-milling", "examples", peripheral_milling_examples()},
      ExampleFile{"heidenhain/peripheral-milling", "rules", peripheral_milling_rules()},
      ExampleFile{"heidenhain/programmed-contour", "examples", programmed_contour_examples()},
      ExampleFile{"heidenhain/programmed-contour", "rules", programmed_contour_rules()},
  };
  return kFiles;
}

}  // namespace toolcomp::corpus
