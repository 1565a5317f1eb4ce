// SPDX-License-Identifier: Apache-2.0
#include "fuzz/parallel/lead.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

namespace toolcomp::fuzz {
namespace {

template <class Value>
void add(std::string& kind, const Value& value) {
  kind += std::to_string(static_cast<std::uint64_t>(value));
  kind += ' ';
}

}  // namespace

std::string kind_of(const spec::Block& block) {
  constexpr std::string_view replaced = "XYZABCUVWIJKRFSQ";
  std::string kind;
  for (const spec::Word& word : block.words()) {
    kind += word.address;
    if (replaced.find(word.address) == std::string_view::npos) kind += spec::to_string(word.value);
  }
  return kind;
}

std::string kind_of(const spec::klartext::Block& block) {
  using spec::klartext::Statement;
  std::string kind;
  add(kind, block.statement);
  const bool moves = block.statement == Statement::line || block.statement == Statement::line_with_vectors;
  if (!moves) return kind + spec::klartext::to_string(block);
  add(kind, block.axes);
  add(kind, block.incremental);
  add(kind, block.has_normal);
  add(kind, block.has_tool_vector);
  add(kind, block.radius);
  add(kind, block.feed);
  for (std::size_t i = 0; i < block.functions; ++i) add(kind, block.function.at(i));
  return kind;
}

namespace {

bool is_code(const spec::Word& word, std::string_view begins) {
  return word.address == 'G' && spec::to_string(word.value).starts_with(begins);
}
bool has(const spec::Block& block, std::string_view letters) {
  return std::ranges::any_of(
      block.words(), [letters](const spec::Word& w) { return letters.find(w.address) != std::string_view::npos; });
}
// What a code of group 01 says; nothing without one.
std::optional<bool> is_arc(const spec::Block& block) {
  std::optional<bool> arc;
  for (const spec::Word& word : block.words())
    if (word.address == 'G' && word.value.is_integer() && word.value.digits < 4) arc = word.value.digits > 1;
  return arc;
}
bool starts(const spec::Word& word) { return is_code(word, "41") || is_code(word, "42"); }
void add(spec::Block& block, const spec::Word& word) { block.word.at(block.size++) = word; }
void erase(spec::Block& block, const auto& is) {
  auto* const end = block.word.begin() + static_cast<std::ptrdiff_t>(block.size);
  block.size = static_cast<std::size_t>(std::remove_if(block.word.begin(), end, is) - block.word.begin());
}

}  // namespace

std::optional<std::vector<spec::Block>> with_late_start(std::vector<spec::Block> lead, std::size_t latest,
                                                        std::size_t most) {
  std::vector<spec::Word> words;  // that start it: the code, and its number
  bool arc = false;
  bool started = false;
  const std::size_t first = lead.size() - std::min(latest, lead.size());
  for (std::size_t i = 0; i < first; ++i) {
    arc = is_arc(lead[i]).value_or(arc);
    const auto in_block = lead[i].words();
    if (std::ranges::any_of(in_block, [](const spec::Word& w) { return is_code(w, "40"); })) words.clear();
    if (std::ranges::none_of(in_block, starts)) continue;
    started = true;
    words.clear();
    std::ranges::copy_if(in_block, std::back_inserter(words),
                         [](const spec::Word& w) { return starts(w) || w.address == 'D' || w.address == 'Q'; });
    erase(lead[i], starts);
  }
  if (!started) return std::nullopt;
  const auto at = [&lead](std::size_t index) { return lead.begin() + static_cast<std::ptrdiff_t>(index); };
  // Arcs do not begin where a leap ends.
  const auto without_arcs_before = [&] {
    lead.erase(
        std::remove_if(lead.begin(), at(first), [](const spec::Block& b) { return has(b, "IJKR") && has(b, "XYZ"); }),
        at(first));
    return std::move(lead);
  };
  if (words.empty()) return without_arcs_before();
  for (std::size_t i = first; i < std::min(lead.size(), first + most); ++i) {
    spec::Block& block = lead[i];
    arc = is_arc(block).value_or(arc);
    if (arc || !has(block, "XYZ") || block.size + words.size() > spec::Block::kMaxWords) continue;
    for (const spec::Word& word : words) add(block, word);
    lead.erase(at(first), at(i));
    return without_arcs_before();
  }
  return std::nullopt;
}

template <class Block>
void Lead<Block>::add(const Block& block) {
  latest_.push_back(std::make_shared<const Known>(Known{count_++, kind_of(block), block}));
  if (latest_.size() <= kAround + latest_most_) return;
  // The block that is now one too far back; with the first of them, those before it.
  for (std::size_t at = count_ == latest_.size() ? 0 : kAround; at <= kAround; ++at) remember(at);
  latest_.pop_front();
}

template <class Block>
void Lead<Block>::remember(std::size_t at) {
  const Known& block = *latest_[at];
  // Inside a run of one kind: its end is to come.
  const auto kind_at = [this](std::size_t index) { return std::string_view(latest_[index]->kind); };
  if (at > 0 && latest_.size() > at + 2 && kind_at(at - 1) == block.kind && kind_at(at + 1) == block.kind &&
      kind_at(at + 2) == block.kind)
    return;
  auto found = kinds_.find(block.kind);
  if (found == kinds_.end()) {
    // More kinds than a program has for a good reason: no guess will be right.
    if (kinds_.size() == kMostKinds) kinds_.clear();
    found = kinds_.try_emplace(block.kind).first;
  }
  if (found->second.size() == 2) found->second.pop_front();
  const auto begin = latest_.begin() + static_cast<std::ptrdiff_t>(at);
  found->second.emplace_back(begin - static_cast<std::ptrdiff_t>(std::min(at, kAround)),
                             begin + static_cast<std::ptrdiff_t>(std::min(latest_.size() - at, kAround + 1)));
}

template <class Block>
std::vector<Block> Lead<Block>::blocks() const {
  std::map<std::uint64_t, const Block*> numbered;
  const auto add = [&numbered](const Shared& known) { numbered.emplace(known->number, &known->block); };
  for (const auto& [kind, latest] : kinds_)
    for (const std::vector<Shared>& around : latest) std::ranges::for_each(around, add);
  std::ranges::for_each(latest_, add);
  std::vector<Block> blocks;
  blocks.reserve(numbered.size());
  for (const auto& [number, block] : numbered) blocks.push_back(*block);
  return blocks;
}

template class Lead<spec::Block>;
template class Lead<spec::klartext::Block>;

}  // namespace toolcomp::fuzz
