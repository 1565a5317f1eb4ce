#include "cli/program.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <thread>

#include "fuzz/oracle/control.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/document.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/joined_program.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::cli {
namespace {

namespace fs = std::filesystem;

bool is_json(const std::string& path) { return fs::path(path).extension() == ".json"; }

// A program begins with anything but `{`; blanks and line feeds may stand before it.
bool begins_with_brace(const std::string& path) {
  const auto source = spec::file_source(path);
  std::array<char, 4096> buffer{};
  const std::size_t size = source->read(buffer.data(), buffer.size());
  for (std::size_t i = 0; i < size; ++i)
    if (std::string_view(" \t\r\n").find(buffer[i]) == std::string_view::npos) return buffer[i] == '{';
  return false;
}

std::string setup_beside(const std::string& path) {
  const fs::path beside = fs::path(path).parent_path() / "setup.toml";
  if (path == "-" || !fs::exists(beside))
    throw spec::InputError(path, 0, 0, "a program needs --setup, or a setup.toml beside it");
  return beside.string();
}

// Where the key of a message such as "parameters.19682: …" stands in the text of a setup; where it does not, what it
// would stand in.
spec::document::Position place_of(const spec::document::Node& root, std::string_view message) {
  spec::document::Position at = root.at;
  const spec::document::Node* node = &root;
  std::string_view key = message.substr(0, message.find(':'));
  while (!key.empty()) {
    std::string name(key.substr(0, key.find('.')));
    key.remove_prefix(std::min(key.size(), name.size() + 1));
    std::erase(name, '"');
    const auto member = std::ranges::find(node->members, name, &spec::document::Member::name);
    if (member == node->members.end()) break;
    at = member->at;
    node = &member->value;
  }
  return at;
}

template <class Number>
struct Nothing final : spec::EventSink<Number> {
  void on(const spec::Event<Number>& /*event*/) override {}
};

}  // namespace

spec::Setup read_setup(const std::string& path) {
  const std::string text = spec::read_file(path);
  spec::Setup setup = is_json(path) ? spec::read_setup_json(text, path) : spec::read_setup_toml(text, path);
  try {
    check_setup(setup);
  } catch (const spec::InputError& error) {
    // The engines know the key at fault, not the file.
    if (error.file() != "setup") throw;
    const auto root = is_json(path) ? spec::document::parse_json(text, path) : spec::document::parse_toml(text, path);
    const auto at = place_of(root, error.message());
    throw spec::InputError(path, at.line, at.column, error.message());
  }
  return setup;
}

void check_setup(const spec::Setup& setup) {
  model::Recorder recorder;
  Nothing<exact::Real> exact_sink;
  Nothing<double> fast_sink;
  fuzz::with_control(setup, [&]<class Control>(Control) {
    const auto model = Control::model(setup, recorder, exact_sink, 0);
    const auto fast = Control::fast(setup, fast_sink, 0);
  });
}

Program::Program(const std::string& path, const std::string& setup, std::optional<std::uint32_t> samples)
    : path_(path) {
  // Standard input cannot be looked at twice: it is always a program.
  is_case_ = path != "-" && (is_json(path) || begins_with_brace(path));
  if (is_case_) {
    if (!setup.empty()) throw spec::InputError(path, 0, 0, "a case brings its own setup; leave out --setup");
    case_ = spec::read_case(spec::read_file(path), path);
  } else {
    case_.setup = read_setup(setup.empty() ? setup_beside(path) : setup);
    case_.dialect = spec::dialect_of(case_.setup.control);
    case_.id = path;
  }
  if (samples) case_.samples = *samples;
  called_ = std::make_unique<CalledFiles>(path, case_.setup.control);
}

fuzz::StreamedProgram Program::text() const {
  return {[this] { return is_case_ ? spec::text_source(case_.program) : spec::file_source(path_); }, path_ == "-",
          spec::display_name(path_), is_case_ ? spec::CalledProgram() : called_->finder()};
}

spec::Case Program::as_case() const {
  spec::Case whole = case_;
  if (is_case_) return whole;
  whole.program = spec::read_file(path_);
  const spec::CalledProgram called = called_->finder();
  if (!called) return whole;
  whole.program =
      case_.setup.control == spec::Control::heidenhain
          ? spec::klartext::joined_klartext(whole.program, called)
          : spec::joined_program(whole.program, case_.setup.axes,
                                 {.file = path_, .block_skip = case_.setup.block_skip, .called_program = called});
  return whole;
}

Place Program::place(std::uint64_t line, std::uint64_t column) const { return called_->place(line, column); }

spec::InputError Program::placed(const spec::InputError& error) const {
  if (error.line() == 0 || error.file() != spec::display_name(path_)) return error;
  const Place at = place(error.line(), error.column());
  return {at.file == path_ ? error.file() : at.file, at.line, at.column, error.message()};
}

unsigned jobs_for(const Program& program, unsigned asked) {
  constexpr std::uintmax_t worth_it = 1 << 18;  // bytes
  if (program.text().once || program.is_case()) return 1;
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(program.path(), unknown);
  if (unknown || size < worth_it) return 1;
  return asked != 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

void expect_readable(const spec::Case& c, const std::string& name) {
  Nothing<double> nowhere;
  fuzz::with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::fast(c.setup, nowhere, 0);
    auto reader = Control::reader(spec::text_source(c.program), c.setup, name);
    typename Control::Block block;
    while (!engine.stopped() && reader.next(block)) engine.block(block);
  });
}

void expect_folder(const std::string& path, const std::string& option) {
  // The nearest of the folders above it that exists; "" is the one we are in.
  fs::path place = path;
  std::error_code error;
  while (!place.empty() && !fs::exists(place, error)) place = place.parent_path();
  if (!place.empty() && !fs::is_directory(place, error))
    throw spec::InputError(option, 0, 0, place.string() + " is no folder");
}

void report_alarm(const std::string& file, std::uint64_t line, std::uint64_t column, std::string_view number,
                  std::string_view message) {
  std::cerr << spec::display_name(file) << ':' << line << ':' << column << ": " << number;
  if (!message.empty()) std::cerr << ' ' << message;
  std::cerr << '\n';
}

void RecentBlocks::add(const spec::Block& block) {
  latest_ = &block;
  add(block.line, {block.line, block.alarm ? block.alarm->column : block.size > 0 ? block.word[0].column : 1});
}

void RecentBlocks::add(const spec::klartext::Block& block) {
  add(block.line,
      block.alarm ? LineColumn{block.alarm->line, block.alarm->column} : LineColumn{block.line, block.column});
}

RecentBlocks::LineColumn RecentBlocks::place(std::uint64_t line) const {
  // Looked for here, not in every block that is read.
  if (latest_ != nullptr && latest_->line == line && !latest_->alarm)
    if (const spec::Word* const beyond = spec::word_not_supported(*latest_)) return {line, beyond->column};
  // The latest block of the line: an alarm ends the run, so no block behind the one at fault was read for it, except
  // within the look-ahead.
  for (std::size_t i = next_; i > 0 && next_ - i < places_.size(); --i)
    if (const Known& known = places_[(i - 1) % places_.size()]; known.line == line) return known.place;
  return {line, 1};
}

}  // namespace toolcomp::cli
