// SPDX-License-Identifier: Apache-2.0
// Setups as text: no files here.
#include <algorithm>
#include <string>
#include <string_view>

#include "certify/input/program.h"
#include "judge/oracle/control.h"
#include "spec/language/document.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::input {
namespace {

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

spec::Setup read_setup_text(const std::string& text, const std::string& name, bool json) {
  spec::Setup setup = json ? spec::read_setup_json(text, name) : spec::read_setup_toml(text, name);
  try {
    check_setup(setup);
  } catch (const spec::InputError& error) {
    // The engines know the key at fault, not the file.
    if (error.file() != "setup") throw;
    const auto root = json ? spec::document::parse_json(text, name) : spec::document::parse_toml(text, name);
    const auto at = place_of(root, error.message());
    throw spec::InputError(name, at.line, at.column, error.message());
  }
  return setup;
}

void check_setup(const spec::Setup& setup) {
  model::Recorder recorder;
  Nothing<exact::Real> exact_sink;
  Nothing<double> fast_sink;
  judge::with_control(setup, [&]<class Control>(Control) {
    const auto model = Control::model(setup, recorder, exact_sink, 0);
    const auto fast = Control::fast(setup, fast_sink, 0);
  });
}

}  // namespace toolcomp::certify::input
