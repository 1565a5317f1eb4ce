// SPDX-License-Identifier: Apache-2.0
#include "corpus/share.h"

#include <charconv>

#include "spec/language/input_error.h"

namespace toolcomp::corpus {

void set_shard(Share& share, const std::string& text) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, share.index);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = std::from_chars(slash ? first.ptr + 1 : end, end, share.count);
  if (!slash || second.ec != std::errc() || second.ptr != end || share.index < 1 || share.index > share.count)
    throw spec::InputError("--shard", 0, 0, "expected a shard I/N with 1 <= I <= N");
}

}  // namespace toolcomp::corpus
