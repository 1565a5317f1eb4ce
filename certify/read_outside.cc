// SPDX-License-Identifier: Apache-2.0
// What strangers send to those who certify: the first byte says which reader, the rest is what it reads. Read or
// refused with an error of input; what is read is printed without a byte that a terminal obeys.
#include <sstream>
#include <string>
#include <string_view>

#include "certify/answer.h"
#include "certify/bundle/manifest.h"
#include "certify/bundle/refused.h"
#include "certify/capabilities.h"
#include "certify/finding.h"
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
      case 'm':
        return void(certify::bundle::read_manifest(rest));
      case 't':
        return read_recording(rest);
      default:
        return;
    }
  } catch (const spec::InputError& error) {
    require_shown(error.what());
  } catch (const certify::bundle::Refused&) {  // NOLINT(bugprone-empty-catch): it says why to whoever verifies
  }
}

}  // namespace

TOOLCOMP_READER_TARGET("read_outside", hold)
