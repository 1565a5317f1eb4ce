// SPDX-License-Identifier: Apache-2.0
// What strangers send to those who certify: the first byte says which reader, the rest is what it reads. Read or
// refused with an error of input; what is read is printed without a byte that a terminal obeys.
#include <sstream>
#include <string>
#include <string_view>

#include "certify/adapter.h"
#include "certify/answer.h"
#include "certify/bundle/manifest.h"
#include "certify/capabilities.h"
#include "certify/finding.h"
#include "certify/kit/kit_json.h"
#include "certify/trace/recording.h"
#include "certify/trace/samples.h"
#include "fuzz/targets/worker.h"
#include "spec/language/input_error.h"
#include "spec/language/printable.h"

namespace {

using namespace toolcomp;
using fuzz::require;

void require_shown(std::string_view text) {
  for (; !text.empty(); text.remove_prefix(spec::shown_length(text))) require(spec::shown_length(text) != 0);
}

void read_recording(std::string_view text) {
  std::istringstream stream{std::string(text)};
  certify::Recording recording(stream, "recording", spec::Axes("XYZBC"), spec::Units::mm);
  for (certify::RecordedSample sample; recording.next(sample);)
    for (const double position : sample.at) require(position <= certify::kFarthest && position >= -certify::kFarthest);
}

void read_answer(std::string_view text) {
  spec::Case c;
  c.id = "a";
  c.setup.axes = spec::Axes("XYZBC");
  certify::Capabilities all;
  all.fields = certify::all_fields();
  const certify::Answer answer = certify::read_answer(all, c, std::string(text));
  if (const auto* fault = std::get_if<certify::Fault>(&answer.result)) require_shown(fault->what);
}

void read_hello(std::string_view text) {
  const certify::Capabilities said = certify::read_capabilities(text);
  require_shown(said.name + said.version);
  const certify::Capabilities again = certify::read_capabilities(certify::write_capabilities(said));
  require(again.name == said.name && again.fields == said.fields && again.setup == said.setup);
}

void read_finding(std::string_view text) {
  const certify::Finding finding = certify::read_finding(text, "finding");
  require(certify::read_finding(certify::write_finding(finding), "again").smallest.program == finding.smallest.program);
}

void read_kit(std::string_view text) {
  const certify::kit::Kit kit = certify::kit::read_kit_json(text, "kit.json");
  for (const certify::kit::KitProgram& program : kit.programs) require(program.group < kit.groups.size());
  for (const auto& [name, digest] : kit.files) require(!name.starts_with('/') && name.find("..") == std::string::npos);
}

void read_adapters(std::string_view text) {
  for (const certify::Adapter& adapter : certify::read_manifest(text, "/nowhere/manifest.toml")) {
    require(certify::is_adapter_name(adapter.name));
    require(adapter.kind != certify::AdapterKind::trace || adapter.tolerance > 0);
  }
}

void hold(std::string_view text) {
  if (text.empty()) return;
  const std::string_view rest = text.substr(1);
  try {
    switch (text.front()) {
      case 'a':
        return read_answer(rest);
      case 'f':
        return read_finding(rest);
      case 'h':
        return read_hello(rest);
      case 'k':
        return read_kit(rest);
      case 'p':
        return read_adapters(rest);
      case 'm':
        return void(certify::bundle::read_manifest(rest));
      case 't':
        return read_recording(rest);
      default:
        return;
    }
  } catch (const spec::InputError& error) {
    require_shown(error.what());
  }
}

}  // namespace

TOOLCOMP_READER_TARGET("read_outside", hold)
