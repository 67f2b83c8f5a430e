// SPDX-License-Identifier: Apache-2.0
// Mutation on several machines. Each machine tests a shard (a part) of the alterations, and one machine merges the
// outcomes. The merged run writes the same files, byte for byte, as a run on one machine, provided that the tests ran
// in the same order.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/test_server.hpp"
#include "host/base/shard.hpp"

namespace canproof::host {

/// Returns the name of a shard's file: `code_mutation-2-of-3.json`.
std::string mutation_shard_name(bool code, const Shard& shard);

/// Returns the outcomes of a shard as JSON. `sources` is the source_hash() of the sources that the machine tested.
std::string write_mutation_shard(const Shard& shard, const std::string& sources,
                                 const std::vector<MutationOutcome>& outcomes);

/// Returns the outcomes of `cells` from the shards in `folder`, in the order of `cells`. Throws InputError when a shard
/// is missing, is present twice, comes from other sources, or has other alterations.
std::vector<MutationOutcome> merge_mutation_shards(const std::filesystem::path& folder, bool code,
                                                   const std::vector<AlteredCell>& cells);

}  // namespace canproof::host
