// SPDX-License-Identifier: Apache-2.0
// Writes the style and the script of the interactive view as C++: `toolcomp_embed STYLE SCRIPT OUTPUT`.
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "spec/generated_source.h"

namespace {

std::string read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

// A function that returns the text. Nothing in it may end the element of HTML in which it will stand.
std::string function(std::string_view name, std::string_view text) {
  constexpr std::size_t kPiece = 30'000;
  for (const std::string_view word : {"</script", "</style", "<!--"})
    if (text.find(word) != std::string_view::npos)
      throw std::runtime_error(std::string(name) + " contains " + std::string(word));
  std::string pieces;
  for (; !text.empty(); text.remove_prefix(std::min(kPiece, text.size())))
    pieces += "    " + toolcomp::spec::literal(text.substr(0, kPiece)) + "sv,\n";
  return "std::span<const std::string_view> " + std::string(name) +
         "() {\n  static constexpr std::string_view kPieces[] = {\n" + pieces + "  };\n  return kPieces;\n}\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    toolcomp::spec::write_changed(argv[3],
                                  "#include \"certify/view/assets.h\"\n\nnamespace toolcomp::certify {\n\nusing "
                                  "namespace std::string_view_literals;\n\n" +
                                      function("view_style", read(argv[1])) + "\n" +
                                      function("view_script", read(argv[2])) + "\n}  // namespace toolcomp::certify\n");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
