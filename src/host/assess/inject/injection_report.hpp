// SPDX-License-Identifier: Apache-2.0
// The results of an injection campaign as a table, as JSON, and as the file of a shard (the part for one of several
// machines).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

#include "host/assess/inject/run_faults.hpp"

namespace canproof::host {

/// The number of runs for each effect of the injected fault.
struct EffectCounts {
    std::array<std::size_t, fault_effects> of{};

    std::size_t all() const;
    /// Returns the number of runs in which the fault had an effect (any effect except `masked`).
    std::size_t effective() const;
    std::size_t detected() const;
    std::size_t silent() const;
};

/// Counts the effects of all runs, or of the runs with a fault in one memory region.
EffectCounts count_effects(const InjectionCampaign& campaign);
EffectCounts count_effects(const InjectionCampaign& campaign, std::size_t region);

/// Returns a table of the effects by region as text, with the share of runs with an effect. The shares of detected
/// faults, of the safe state and of silent faults refer to the runs with an effect.
std::string injection_table(const std::string& device, const InjectionOptions& options,
                            const InjectionCampaign& campaign);
/// Returns JSON with the counts and with every fault that has a silent effect (a wrong value without any sign of the
/// fault).
std::string injection_json(const std::string& device, const InjectionOptions& options,
                           const InjectionCampaign& campaign);

/// Returns the name of a shard's file, such as `inject-cbx-ao412-2-of-3.json`.
std::string injection_shard_name(const std::string& device, const Shard& shard);
/// Returns the content of a shard's file: all runs of the shard.
std::string write_injection_shard(const std::string& device, const InjectionOptions& options,
                                  const InjectionCampaign& campaign);
/// Merges all shards of `device` in a folder. Returns the campaign as one machine would have run it, and sets the seed
/// and the number of faults in `options`. Throws InputError when a shard is missing, is present twice, or belongs to
/// another campaign.
InjectionCampaign merge_injection_shards(const std::filesystem::path& folder, const std::string& device,
                                         InjectionOptions& options);

}  // namespace canproof::host
