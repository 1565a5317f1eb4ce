#include <array>

#include "corpus/examples.h"

namespace toolcomp::corpus {

std::span<const ExampleFile> example_files() {
  static const std::array kFiles{
      ExampleFile{"fanuc/tool-length-offset", "examples", tool_length_offset_examples()},
      ExampleFile{"fanuc/tool-length-offset", "rules", tool_length_offset_rules()},
      ExampleFile{"fanuc/leading-edge-offset", "examples", leading_edge_offset_examples()},
      ExampleFile{"fanuc/leading-edge-offset", "rules", leading_edge_offset_rules()},
  };
  return kFiles;
}

}  // namespace toolcomp::corpus
