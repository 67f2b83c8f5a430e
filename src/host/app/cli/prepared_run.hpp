// SPDX-License-Identifier: Apache-2.0
// The devices, the bus and the files that the command line of `run` or `panel` names.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "host/app/cli/output_file.hpp"
#include "host/app/cli/run_command.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/run/node_ids.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host {

class PreparedRun {
  public:
    /// Makes the session. `frames` receives every frame as a line; `frames` and `observer` may be nullptr. Throws
    /// InputError.
    PreparedRun(const RunOptions& options, std::ostream* frames, SessionObserver* observer, NoticeListener notice);

    RunSession& session() { return *session_; }
    /// Returns the requirements register's description of the device of each node, in the order of the session's nodes.
    const std::vector<const Part*>& parts() const { return parts_; }

    /// Opens and locks the log and the outputs. Called before power-on, after all checks. Throws InputError.
    void open_outputs();
    /// Sends a notice for each node-ID that several devices have, unless the previous call found the same devices with
    /// this node-ID.
    void tell_node_ids();
    /// Writes the buffered text of the log and the outputs to their files. The first call after the bus was joined
    /// empties the files.
    void flush();
    /// Flushes the files. Throws InputError when one of them could not be written completely.
    void finish();

  private:
    NoticeListener notice_;
    NodeIdClashes clashes_;
    std::vector<std::string> inputs_;  ///< files that the run reads or keeps
    bool started_{false};              ///< the program has joined its bus
    OutputFile log_;
    OutputFile outputs_;
    std::vector<const Part*> parts_;
    std::unique_ptr<RunSession> session_;
};

}  // namespace canproof::host
