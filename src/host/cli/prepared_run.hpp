// Devices on a bus as a command line asks for them, with the files that go in and out: what `run` and `panel` share.
#pragma once

#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "host/cli/chosen_devices.hpp"
#include "host/cli/commands.hpp"
#include "host/run/run_session.hpp"

namespace canproof::host {

class PreparedRun {
  public:
    /// `frames` gets every frame as a line; it and `observer` may be nullptr. Throws InputError.
    PreparedRun(const RunOptions& options, std::ostream* frames, SessionObserver* observer, NoticeListener notice);

    RunSession& session() { return *session_; }
    /// What describes each node of the session.
    const std::vector<const Part*>& parts() const { return parts_; }

    /// The log and the outputs, as far as they are written, to their files.
    void flush();
    /// The files to their end. Throws InputError.
    void finish();

  private:
    std::ofstream log_;
    std::ofstream outputs_;
    std::vector<const Part*> parts_;
    std::unique_ptr<RunSession> session_;
};

}  // namespace canproof::host
