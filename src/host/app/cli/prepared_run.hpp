// Devices on a bus as a command line asks for them, with the files that go in and out: what `run` and `panel` share.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "host/app/cli/chosen_devices.hpp"
#include "host/app/cli/output_file.hpp"
#include "host/app/cli/run_command.hpp"
#include "host/sim/run/node_ids.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host {

class PreparedRun {
  public:
    /// `frames` gets every frame as a line; it and `observer` may be nullptr. Throws InputError.
    PreparedRun(const RunOptions& options, std::ostream* frames, SessionObserver* observer, NoticeListener notice);

    RunSession& session() { return *session_; }
    /// What describes each node of the session.
    const std::vector<const Part*>& parts() const { return parts_; }

    /// The log and the outputs, emptied: before power-on, when nothing can refuse any more. Throws InputError.
    void open_outputs();
    /// A notice for each node-ID that more than one device has since the last call.
    void tell_node_ids();
    /// The log and the outputs, as far as they are written, to their files.
    void flush();
    /// The files to their end. Throws InputError.
    void finish();

  private:
    NoticeListener notice_;
    NodeIdClashes clashes_;
    std::string stimulus_;
    OutputFile log_;
    OutputFile outputs_;
    std::vector<const Part*> parts_;
    std::unique_ptr<RunSession> session_;
};

}  // namespace canproof::host
