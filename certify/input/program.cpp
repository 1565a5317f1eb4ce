// SPDX-License-Identifier: Apache-2.0
#include "certify/input/program.h"

#include <array>
#include <filesystem>

#include "judge/oracle/control.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/joined_program.h"

namespace toolcomp::certify::input {
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
    throw spec::InputError(path, 0, 0, "a program needs --setup, or a setup.toml in its folder");
  return beside.string();
}

struct Nothing final : spec::EventSink<double> {
  void on(const spec::Event<double>& /*event*/) override {}
};

}  // namespace

spec::Setup read_setup(const std::string& path) { return read_setup_text(spec::read_file(path), path, is_json(path)); }

// Standard input cannot be looked at twice: it is always a program.
Program::Program(const std::string& path, const std::string& setup, std::optional<std::uint32_t> samples)
    : path_(path), is_case_(path != "-" && (is_json(path) || begins_with_brace(path))) {
  if (is_case_) {
    if (!setup.empty()) refuse_setup();
    case_ = spec::read_case(spec::read_file(path), path);
    if (samples) case_.samples = *samples;
  } else {
    take(read_setup(setup.empty() ? setup_beside(path) : setup), samples);
  }
  called_ = std::make_unique<CalledFiles>(path, case_.setup.control);
}

Program::Program(const std::string& path, const spec::Setup& setup, std::optional<std::uint32_t> samples)
    : path_(path) {
  if (path != "-" && (is_json(path) || begins_with_brace(path))) refuse_setup();
  take(setup, samples);
  called_ = std::make_unique<CalledFiles>(path, case_.setup.control);
}

Program::Program(std::string name, spec::Case c)
    : path_(std::move(name)),
      case_(std::move(c)),
      is_case_(true),
      called_(std::make_unique<CalledFiles>(path_, case_.setup.control)) {}

void Program::refuse_setup() const {
  throw spec::InputError(path_, 0, 0, "a case brings its own setup; leave out --setup");
}

void Program::take(spec::Setup setup, std::optional<std::uint32_t> samples) {
  case_.setup = std::move(setup);
  case_.dialect = spec::dialect_of(case_.setup.control);
  case_.id = path_;
  if (samples) case_.samples = *samples;
}

judge::StreamedProgram Program::text() const {
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
          : spec::joined_program(whole.program, case_.setup.axes, spec::reader_options(case_.setup, path_, called));
  return whole;
}

Place Program::place(std::uint64_t line, std::uint64_t column) const { return called_->place(line, column); }

spec::InputError Program::placed(const spec::InputError& error) const {
  if (error.line() == 0 || error.file() != spec::display_name(path_)) return error;
  const Place at = place(error.line(), error.column());
  return {at.file == path_ ? error.file() : at.file, at.line, at.column, error.message()};
}

void expect_readable(const spec::Case& c, const std::string& name) {
  Nothing nowhere;
  judge::with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::fast(c.setup, nowhere, 0);
    auto reader = Control::reader(spec::text_source(c.program), c.setup, name);
    typename Control::Block block;
    while (!engine.stopped() && reader.next(block)) engine.block(block);
  });
}

}  // namespace toolcomp::certify::input
