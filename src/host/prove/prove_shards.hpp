// SPDX-License-Identifier: Apache-2.0
// Theorems on several machines: each decides a shard of them, and one merges the results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/shard.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns the results of a shard as JSON, for merge_shards().
std::string shard_text(const Shard& shard, const std::vector<TheoremResult>& results);

/// Returns the results of all theorems, in the order of one machine, from the shards' files `*.json` in `folder`.
/// Throws InputError when a shard is missing, is there twice, or belongs to another set of theorems.
std::vector<TheoremResult> merge_shards(const std::filesystem::path& folder);

}  // namespace canproof::host::prove
