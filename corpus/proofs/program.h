// A program as the proofs read it: words by line. Independent of the engines' interpretation.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "model/exact/real.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::corpus {

using exact::Rational;

// The value of the decimal, and as Coq writes it.
Rational value_of(const spec::Decimal& decimal);
std::string coq(const Rational& value);
std::string coq(const spec::Decimal& decimal);

// The recorded number as a fraction, where it is one.
std::optional<Rational> fraction_of(const spec::NumberText& number);
// v and r as Coq writes them.
std::string coq_decimal(std::string_view text);

// The value in tool offset memory that an H (or D) of this number applies, without G10.
Rational offset_of(const spec::Setup& setup, char address, std::uint64_t number);

// The blocks of a program by line; nothing if a block has a read alarm or a number that is not in millimetres or
// inches.
std::optional<std::map<std::uint64_t, spec::Block>> blocks_of(const spec::Case& c);

// Has the block the word, such as "G43.5"? The value of the last word of an address.
bool has(const spec::Block& block, std::string_view word);
std::optional<spec::Decimal> word(const spec::Block& block, char address);

// An identifier of Coq from a vector's id.
std::string identifier(std::string_view id);

}  // namespace toolcomp::corpus
