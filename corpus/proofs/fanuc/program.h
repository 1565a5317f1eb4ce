// A program as the proofs read it: words by line. Independent of the engines' interpretation.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "corpus/proofs/numbers.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::corpus {

// The value in tool offset memory that an H (or D) of this number applies, without G10.
Rational offset_of(const spec::Setup& setup, char address, std::uint64_t number);

// The blocks of a program by line; nothing if a block has a read alarm or a number that is not in millimetres or
// inches.
using Blocks = std::map<std::uint64_t, spec::Block>;
std::optional<Blocks> blocks_of(const spec::Case& c);

// Has the block the word, such as "G43.5"? The value of the last word of an address.
bool has(const spec::Block& block, std::string_view word);
std::optional<spec::Decimal> word(const spec::Block& block, char address);

}  // namespace toolcomp::corpus
