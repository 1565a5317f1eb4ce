// SPDX-License-Identifier: Apache-2.0
// Shards of corpus generation: what each of N machines found, as a file, and the corpus made of all of them.
#pragma once

#include <filesystem>

#include "corpus/generate.h"
#include "corpus/share.h"

namespace toolcomp::corpus {

// FOLDER/shard-I-of-N.jsonl.
std::filesystem::path shard_file(const std::filesystem::path& folder, const Share& share);

// Looks at this share of the candidates of every section and writes what may be chosen to the shard's file in
// `options.folder`. The file stands there whole or not at all, so a shard that was lost is one that is missing. Throws
// as `generate` does.
void write_shard(const GenerateOptions& options, const Share& share);

// Makes the corpus in `options.folder` of the shards in `shards`: the same bytes as `generate` with the seed, sections
// and numbers of the shards, which replace those of `options`. Throws spec::InputError where shards are missing (all of
// them named), damaged, of another run or of another build of toolcomp.
GenerateResult merge_shards(const std::filesystem::path& shards, const GenerateOptions& options);

}  // namespace toolcomp::corpus
