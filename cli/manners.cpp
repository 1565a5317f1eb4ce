// SPDX-License-Identifier: Apache-2.0
#include "cli/manners.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <iostream>

namespace toolcomp::cli {
namespace {

Manners manners_now;

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
  return value == nullptr ? "" : value;
}

int descriptor(Stream stream) { return stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO; }

bool is_terminal(Stream stream) {
  return ::isatty(descriptor(stream)) == 1 && !variable("TERM").empty() && variable("TERM") != "dumb";
}

std::string_view code(Paint paint) {
  switch (paint) {
    case Paint::place:
      return "\033[1m";
    case Paint::good:
      return "\033[32m";
    case Paint::bad:
      return "\033[31m";
    case Paint::doubtful:
      return "\033[33m";
  }
  return "";
}

}  // namespace

void set_manners(const Manners& manners) { manners_now = manners; }

bool is_quiet() { return manners_now.loudness == Loudness::quiet; }
bool is_verbose() { return manners_now.loudness == Loudness::verbose; }

void note(std::string_view line) {
  if (!is_quiet()) std::cerr << line << '\n';
}

void detail(std::string_view line) {
  if (is_verbose()) std::cerr << "toolcomp: " << line << '\n';
}

bool is_colored(Stream stream) {
  if (manners_now.coloring != Coloring::automatic) return manners_now.coloring == Coloring::always;
  if (!variable("NO_COLOR").empty()) return false;
  if (const auto forced = variable("CLICOLOR_FORCE"); !forced.empty() && forced != "0") return true;
  return is_terminal(stream) && variable("CLICOLOR") != "0";
}

std::string painted(Paint paint, std::string_view text, Stream stream) {
  if (!is_colored(stream) || text.empty()) return std::string(text);
  return std::string(code(paint)).append(text).append("\033[0m");
}

std::string painted_diagnostic(std::string_view line) {
  const std::size_t end = line.find(": ");
  if (end == std::string_view::npos) return std::string(line);
  return painted(Paint::place, line.substr(0, end + 1), Stream::err).append(line.substr(end + 1));
}

bool can_redraw() { return !is_quiet() && is_terminal(Stream::err); }

std::size_t columns_of(Stream stream) {
  constexpr std::size_t kUsual = 80;
  const std::string_view given = variable("COLUMNS");
  std::size_t columns = 0;
  if (std::from_chars(given.data(), given.data() + given.size(), columns).ec == std::errc{} && columns > 0)
    return columns;
  winsize size{};
  if (::ioctl(descriptor(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return kUsual;
}

std::string_view first_characters(std::string_view text, std::size_t count) {
  std::size_t byte = 0;
  const auto continues = [&] { return (static_cast<unsigned char>(text[byte]) & 0xC0U) == 0x80U; };
  for (; byte < text.size() && count > 0; --count) do
      ++byte;
    while (byte < text.size() && continues());
  return text.substr(0, byte);
}

}  // namespace toolcomp::cli
