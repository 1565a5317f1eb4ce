// SPDX-License-Identifier: Apache-2.0
#include "spec/language/case_document.h"
#include "spec/language/case_format.h"
#include "spec/language/event_document.h"
#include "spec/language/setup_document.h"

namespace toolcomp::spec {
namespace {

using document::Kind;
using document::Node;
using document::Reader;

const Node& required(const Node& node, std::string_view key, const Reader& read) {
  const Node* found = node.find(key);
  if (found == nullptr) read.fail(node.at, "case: without " + std::string(key));
  return *found;
}

// The control decides which language programs have; a case may say it too.
std::string dialect_from(const Node* node, Control control, const Reader& read) {
  const std::string dialect(dialect_of(control));
  if (node == nullptr) return dialect;
  (void)read.choice(*node, "dialect", {"fanuc", "klartext"});
  if (node->text != dialect)
    read.fail(node->at, "dialect: the control of the setup needs " + document::in_quotes(dialect) + ", found " +
                            document::in_quotes(node->text));
  return dialect;
}

CaseSource source_from(const Node& node, const Reader& read) {
  read.keys(node, "source", {"generator", "version", "seed"});
  CaseSource source;
  if (const Node* generator = node.find("generator")) source.generator = read.string(*generator, "generator");
  if (const Node* version = node.find("version")) source.version = read.string(*version, "version");
  if (const Node* seed = node.find("seed")) source.seed = read.string(*seed, "seed");
  return source;
}

// Of a known difference, as manifests of adapters have it.
bool is_name(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  return !text.empty() && text.size() <= kLongest && text.front() != '-' &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos;
}

}  // namespace

Case case_from(const Node& root, const Reader& read) {
  Case c;
  read.keys(root, "case",
            {"case", "id", "section", "comment", "clauses", "flags", "dialect", "setup", "program", "samples", "source",
             "expect"});
  (void)read.integer(required(root, "case", read), "case", 1, 1);
  if (const Node* id = root.find("id")) c.id = read.string(*id, "id");
  if (const Node* section = root.find("section")) c.section = read.string(*section, "section");
  if (const Node* comment = root.find("comment")) c.comment = read.string(*comment, "comment");
  if (const Node* clauses = root.find("clauses")) c.clauses = read.strings(*clauses, "clauses");
  if (const Node* flags = root.find("flags")) c.flags = read.strings(*flags, "flags");
  c.setup = setup_from(required(root, "setup", read), read);
  c.dialect = dialect_from(root.find("dialect"), c.setup.control, read);
  c.program = read.string(required(root, "program", read), "program");
  if (const Node* samples = root.find("samples"))
    c.samples = static_cast<std::uint32_t>(read.integer(*samples, "samples", 0, kMostSamples));
  if (const Node* source = root.find("source")) c.source = source_from(*source, read);
  if (const Node* expect = root.find("expect")) {
    read.expect(*expect, Kind::array, "expect");
    c.has_expect = true;
    c.expect.reserve(expect->items.size());
    for (const Node& item : expect->items)
      c.expect.push_back(event_from(item, read, c.setup.axes, Strictness::of_cases).event);
  }
  return c;
}

Case read_case(std::string_view text, const std::string& file) {
  return case_from(document::parse_json(text, file), Reader(file));
}

Reply read_reply(std::string_view line, const Axes& axes, const std::string& file) {
  const Node root = document::parse_json(line, file);
  const Reader read(file);
  read.expect(root, Kind::table, "reply");
  const Node* id = root.find("id");
  const Node* events = root.find("events");
  const Node* not_applicable = root.find("not_applicable");
  const Node* error = root.find("error");
  const bool failed = error != nullptr && events == nullptr && not_applicable == nullptr;
  if (id == nullptr && !failed) read.fail(root.at, "reply: without id");
  Reply reply;
  if (id != nullptr) reply.id = read.string(*id, "id");
  const auto reason = [&read](const Node& node, std::string_view name) {
    std::string text = read.string(node, name);
    if (text.empty()) read.fail(node.at, std::string(name) + ": without a reason");
    return text;
  };
  if (failed) {
    reply.error = reason(*error, "error");
    return reply;
  }
  if (not_applicable != nullptr && events == nullptr) {
    reply.not_applicable = reason(*not_applicable, "not_applicable");
    if (const Node* known = root.find("known_difference")) {
      reply.known_difference = read.string(*known, "known_difference");
      if (!is_name(reply.known_difference))
        read.fail(known->at, "known_difference: must be a name of lower case letters, digits and hyphens");
    }
    return reply;
  }
  if (events == nullptr) read.fail(root.at, "reply: without events");
  read.expect(*events, Kind::array, "events");
  for (const Node& item : events->items) {
    // A note is for people, and no event of a run.
    const Node* const kind = item.kind == Kind::table ? item.find("kind") : nullptr;
    if (kind != nullptr && kind->kind == Kind::string && kind->text == "note") continue;
    EventWithFields each = event_from(item, read, axes, Strictness::of_replies);
    reply.events.push_back(std::move(each.event));
    reply.fields.push_back(each.fields);
  }
  return reply;
}

}  // namespace toolcomp::spec
