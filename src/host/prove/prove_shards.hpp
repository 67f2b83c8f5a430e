// SPDX-License-Identifier: Apache-2.0
// Theorems on several machines. Each machine decides a shard (a part) of the theorems, and one machine merges the
// results.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/shard.hpp"
#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns the results of a shard as JSON, for merge_shards(). `sources` is the source_hash() of the proven source
/// tree.
std::string shard_text(const Shard& shard, const std::string& sources, const std::vector<TheoremResult>& results);

/// Returns the results of all theorems from the files `*.json` of the shards in `folder`, in the order of a run on one
/// machine. Throws InputError when a shard is missing, is present twice, or comes from other sources.
std::vector<TheoremResult> merge_shards(const std::filesystem::path& folder);

}  // namespace canproof::host::prove
