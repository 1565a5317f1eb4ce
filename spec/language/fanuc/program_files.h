// Programs in files beside one that calls them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The text of a program that is called ("O1000", or the name in < >), from the file in `folder` that is named after it:
// whatever the ending and the case of its letters, with zeros before the number or not, with O or without. nullopt
// where there is none. Throws InputError where there are two.
std::optional<std::string> program_beside(const std::filesystem::path& folder, std::string_view name);

}  // namespace toolcomp::spec
