// SPDX-License-Identifier: Apache-2.0
// Prepares the slave for a case, runs the case, and restores the parameters that the case changed.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/conform/link/node_control.hpp"
#include "host/conform/link/sdo_client.hpp"
#include "host/conform/run/run_cases.hpp"
#include "host/conform/run/snapshot.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

class CaseRunner {
  public:
    CaseRunner(const CaseBook& book, const ConformSheet& sheet, Target& target, const ConformOptions& options);

    /// Resets the slave and reads its identity and parameters. Adds wrong answers to `report.troubles`. Throws
    /// InputError when the slave does not answer at all.
    void begin(ConformReport& report);
    /// Runs a case. On a real bus, runs a failed case again until it does not fail, at most `most_runs` times in total.
    /// Throws Interrupted.
    CaseResult run(const Case& one);
    /// Restores every parameter that differs from the start of the run. Returns one sentence for each parameter that
    /// could not be restored.
    std::vector<std::string> put_everything_back();
    /// Returns whether the slave answered after its last reset.
    bool is_alive() const { return alive_; }
    /// Returns the numbers of frames and bits on the bus since the runner was made.
    const BusUse& bus_use() const { return link_.bus_use(); }

  private:
    /// The slave's last reset, if the tester has sent no frame since then; otherwise `no`.
    enum class Fresh { no, communication, node };

    void run_once(const Case& one, CaseResult& result);
    void judge(const Case& one, CaseResult& result);
    void check_unasked(const Case& one);
    void clean_up(const Case& one, CaseResult& result);
    /// Brings the slave into the state that a case requires. Throws NoAnswer when the slave does not answer.
    void prepare(Preparation how);
    bool reset(NmtCommand command);
    bool answers();
    Bytes read_at_start(const ObjectPlace& place, ConformReport& report);
    void note_sent(const Frame& frame);
    void set_variables(Scope& scope) const;
    std::string not_allowed(const Case& one) const;
    void save_parameters();

    const CaseBook& book_;
    const ConformSheet& sheet_;
    Target& target_;
    const ConformOptions& options_;
    Link link_;
    Journal journal_;
    SdoClient sdo_;
    Snapshot snapshot_;
    std::set<ObjectPlace> written_;
    bool sent_other_{false};     ///< whether a frame was sent that may have changed more than parameters
    bool may_store_{false};      ///< whether the case may store parameters (its risk is `store`)
    bool store_changed_{false};  ///< whether the parameters that the slave has stored may differ from the snapshot
    Fresh fresh_{Fresh::no};
    bool alive_{true};
    bool boots_silently_{false};  ///< whether the slave answered after a reset without having sent a boot-up message
    std::map<std::string, std::int64_t> identity_;
    std::optional<bool> block_upload_;
    std::optional<bool> block_download_;
};

}  // namespace canproof::host::conform
