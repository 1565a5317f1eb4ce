// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/signature.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string_view>

#include "host/process.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::bundle {
namespace {

struct Outcome {
  int status = -1;
  std::string out;
};

// `words` are shell words. Standard error comes with standard output.
Outcome gpg(const std::string& words) {
  constexpr std::size_t kMost = std::size_t{1} << 16;
  constexpr int kNotFound = 127;
  Outcome outcome;
  // NOLINTNEXTLINE(cert-env33-c): the words are quoted (host::shell_quoted)
  std::FILE* const pipe = ::popen(("gpg --batch --no-tty " + words + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe))
    if (outcome.out.size() < kMost) outcome.out.append(buffer.data(), size);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (outcome.status == kNotFound) outcome.out = "gpg is not installed";
  return outcome;
}

// The last line, for messages.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  return line == std::string::npos ? text : text.substr(line + 1);
}

// What stands behind "[GNUPG:] WORD " in the status lines; `found` says whether there is such a line.
std::string status_of(const std::string& out, std::string_view word, bool& found) {
  const std::string begin = "[GNUPG:] " + std::string(word) + " ";
  std::size_t at = out.starts_with(begin) ? 0 : out.find("\n" + begin);
  found = at != std::string::npos;
  if (!found) return {};
  at = out.find(begin, at) + begin.size();
  return out.substr(at, out.find('\n', at) - at);
}

}  // namespace

std::filesystem::path signature_file(const std::filesystem::path& file) { return file.string() + ".asc"; }

void expect_key(const std::string& key) {
  const Outcome outcome = gpg("--list-secret-keys -- " + host::shell_quoted(key));
  if (outcome.status != 0)
    throw spec::InputError("--sign", 0, 0, "no secret key \"" + key + "\": " + last_line(outcome.out));
}

void sign(const std::filesystem::path& file, const std::string& key) {
  const std::string beside = signature_file(file).string() + ".part";
  const Outcome outcome = gpg("--yes --local-user " + host::shell_quoted(key) + " --detach-sign --armor --output " +
                              host::shell_quoted(beside) + " -- " + host::shell_quoted(file.string()));
  std::error_code error;
  if (outcome.status == 0) std::filesystem::rename(beside, signature_file(file), error);
  if (outcome.status == 0 && !error) return;
  std::error_code ignored;
  std::filesystem::remove(beside, ignored);
  throw spec::InputError("--sign", 0, 0, "the bundle was written, but not signed: " + last_line(outcome.out));
}

Signature check_signature(const std::filesystem::path& file) {
  Signature signature;
  signature.there = std::filesystem::exists(signature_file(file));
  if (!signature.there) return signature;
  const Outcome outcome = gpg("--status-fd 1 --verify -- " + host::shell_quoted(signature_file(file).string()) + " " +
                              host::shell_quoted(file.string()));
  bool good = false;
  bool valid = false;
  const std::string signer = status_of(outcome.out, "GOODSIG", good);
  const std::string fingerprint = status_of(outcome.out, "VALIDSIG", valid);
  signature.good = outcome.status == 0 && good && valid;
  if (signature.good) {
    const std::size_t name = signer.find(' ');
    signature.words = "good, by " + (name == std::string::npos ? signer : signer.substr(name + 1)) + " (" +
                      fingerprint.substr(0, fingerprint.find(' ')) + ")";
    return signature;
  }
  bool bad = false;
  bool no_key = false;
  static_cast<void>(status_of(outcome.out, "BADSIG", bad));
  const std::string key = status_of(outcome.out, "NO_PUBKEY", no_key);
  if (bad)
    signature.words = "it does not belong to this file";
  else if (no_key)
    signature.words = "the public key " + key + " that is needed to check it is missing";
  else
    signature.words = last_line(outcome.out);
  return signature;
}

}  // namespace toolcomp::certify::bundle
