// SPDX-License-Identifier: Apache-2.0
// Shards of corpus generation: a file with the candidates of each of N machines, and the corpus made of all of them.
#pragma once

#include <filesystem>

#include "corpus/generate.h"
#include "corpus/share.h"

namespace toolcomp::corpus {

// FOLDER/shard-I-of-N.jsonl.
std::filesystem::path shard_file(const std::filesystem::path& folder, const Share& share);

// Examines this share of the candidates of every section and writes those that may be chosen to the shard's file in
// `options.folder`. The file is there complete or not at all, so a lost shard is a missing file. Throws as `generate`
// does.
void write_shard(const GenerateOptions& options, const Share& share);

// Makes the corpus in `options.folder` from the shards in `shards`: the same bytes as `generate` with the seed,
// sections and numbers of the shards, which replace those of `options`. Throws spec::InputError if shards are missing
// (all of them named), damaged, from another run or from another build of toolcomp.
GenerateResult merge_shards(const std::filesystem::path& shards, const GenerateOptions& options);

}  // namespace toolcomp::corpus
