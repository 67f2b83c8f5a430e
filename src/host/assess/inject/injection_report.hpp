// SPDX-License-Identifier: Apache-2.0
// The results of an injection campaign as a table, as JSON, and as the file of a shard.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

#include "host/assess/inject/run_faults.hpp"

namespace canproof::host {

/// Numbers of runs by effect.
struct EffectCounts {
    std::array<std::size_t, fault_effects> of{};

    std::size_t all() const;
    /// Runs with any difference.
    std::size_t effective() const;
    std::size_t detected() const;
    std::size_t silent() const;
};

/// Counts the runs of one region, or of all.
EffectCounts count_effects(const InjectionCampaign& campaign);
EffectCounts count_effects(const InjectionCampaign& campaign, std::size_t region);

/// Returns the effects by region as text, with the shares of the effective faults.
std::string injection_table(const std::string& device, const InjectionOptions& options,
                            const InjectionCampaign& campaign);
/// Returns the counts, and every fault with a silent effect.
std::string injection_json(const std::string& device, const InjectionOptions& options,
                           const InjectionCampaign& campaign);

/// `inject-cbx-ao412-2-of-3.json`
std::string injection_shard_name(const std::string& device, const Shard& shard);
/// Returns the file of a shard: all its runs.
std::string write_injection_shard(const std::string& device, const InjectionOptions& options,
                                  const InjectionCampaign& campaign);
/// Returns the campaign of all shards of `device` in a folder, equal to that of one machine; sets the seed and the
/// number of faults of `options`. Throws InputError when a shard is missing, stands there twice, or is of another
/// campaign.
InjectionCampaign merge_injection_shards(const std::filesystem::path& folder, const std::string& device,
                                         InjectionOptions& options);

}  // namespace canproof::host
