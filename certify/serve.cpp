// SPDX-License-Identifier: Apache-2.0
#include "certify/serve.h"

#include <streambuf>

#include "fast/basis/print.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "model/basis/print.h"
#include "spec/language/case_format.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/json_text.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify {
namespace {

void append_exact(std::string& out, const exact::Real& value) { model::append_number(out, value, kModelDigits); }

template <class Number, class AppendNumber>
std::string reply(const spec::Case& c, const std::vector<spec::Event<Number>>& events, const AppendNumber& append) {
  std::string out = "{\"id\":";
  spec::append_json_string(out, c.id);
  out += ",\"events\":[";
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (i > 0) out += ',';
    spec::append_event_json(out, events[i], c.setup.axes, append);
  }
  return out + "]}";
}

// A greeting is told from a case by its one key, without reading either twice.
bool is_hello(std::string_view request) {
  std::string bare;
  for (const char c : request.substr(0, 64))
    if (c != ' ' && c != '\t' && c != '\r') bare += c;
  return bare == "{\"hello\":1}";
}

std::string not_applicable(const spec::Case& c, const std::string& why) {
  std::string out = "{\"id\":";
  spec::append_json_string(out, c.id);
  out += ",\"not_applicable\":";
  spec::append_json_string(out, why);
  return out + '}';
}

// The events of the formal specification, where it says all of the program.
std::string specified(const spec::Case& c) {
  const spec_engine::Run run = spec_engine::run(c);
  if (!run.not_said.empty()) return not_applicable(c, run.not_said);
  return reply(c, run.events, append_exact);
}

std::string refusal(std::string_view what) {
  std::string text = "{\"error\":";
  spec::append_json_string(text, what);
  return text + '}';
}

enum class Line : std::uint8_t { whole, too_long, end };

// The next line without its line feed; of one that is too long, nothing.
Line next_line(std::streambuf& in, std::string& line, std::size_t limit) {
  line.clear();
  bool any = false;
  bool too_long = false;
  for (int c = in.sbumpc(); c != std::char_traits<char>::eof(); c = in.sbumpc()) {
    any = true;
    if (c == '\n') break;
    if (line.size() == limit) too_long = true;
    if (!too_long) line += std::char_traits<char>::to_char_type(c);
  }
  if (!any) return Line::end;
  return too_long ? Line::too_long : Line::whole;
}

}  // namespace

Capabilities served_capabilities(ServedEngine engine) {
  Capabilities c;
  c.version = TOOLCOMP_VERSION;
  if (engine == ServedEngine::specification) {
    c.name = "toolcomp formal specification";
    c.sections = spec_engine::sections();
    c.fields = all_fields();
    return c;
  }
  c.name = engine == ServedEngine::fast ? "toolcomp fast engine" : "toolcomp model";
  for (const std::string_view section : fuzz::sections()) c.sections.emplace_back(section);
  c.fields = all_fields();
  return c;
}

std::string answer(ServedEngine engine, std::string_view request) {
  if (is_hello(request)) return write_capabilities(served_capabilities(engine));
  const spec::Case c = spec::read_case(request, "stdin");
  if (engine == ServedEngine::specification) return specified(c);
  if (engine == ServedEngine::fast)
    return reply(c, judge::run_fast(c), [](std::string& out, double value) { fast::append_number(out, value); });
  return reply(c, judge::run_model(c).events, append_exact);
}

std::uint64_t serve(ServedEngine engine, std::istream& in, std::ostream& out, std::ostream& errors, std::size_t limit) {
  std::uint64_t refused = 0;
  std::uint64_t number = 0;
  std::string line;
  for (Line read = next_line(*in.rdbuf(), line, limit); read != Line::end; read = next_line(*in.rdbuf(), line, limit)) {
    ++number;
    std::string text;
    try {
      if (read == Line::too_long)
        throw spec::InputError("stdin", number, 0, "a request of more than " + std::to_string(limit) + " bytes");
      text = answer(engine, line);
    } catch (const spec::InputError& error) {
      ++refused;
      // A request is one line: its column is the column of the error, its line that of the input.
      const spec::InputError placed(error.file(), error.file() == "stdin" ? number : error.line(), error.column(),
                                    error.message());
      errors << placed.what() << '\n';
      text = refusal(placed.what());
    } catch (const exact::Undecided& error) {
      // Digits that cannot be certified are not printed.
      ++refused;
      errors << "stdin:" << number << ": " << error.what() << '\n';
      text = refusal(error.what());
    }
    out << text << '\n';
    out.flush();
    if (!out) break;
  }
  return refused;
}

}  // namespace toolcomp::certify
