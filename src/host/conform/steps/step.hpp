// SPDX-License-Identifier: Apache-2.0
// A parsed step of a conformance case, and the context in which it runs.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/conform/language/value.hpp"
#include "host/conform/link/link.hpp"
#include "host/conform/link/sdo_client.hpp"
#include "host/conform/link/verdict.hpp"
#include "host/conform/sheet/conform_sheet.hpp"

namespace canproof::host::conform {

struct Context;
using Action = std::function<void(Context&)>;

struct Step {
    std::string text;  ///< text of the step as written in the case
    unsigned line{0};
    Action run;
};
using Steps = std::vector<Step>;

/// Steps that several cases can call.
struct Procedure {
    std::string name;
    std::vector<std::string> takes;
    Steps steps;
    std::string file;
};

/// The context of a running case.
struct Context {
    Context(Link& a_link, SdoClient& a_client, const ConformSheet& a_sheet,
            const std::map<std::string, Procedure>& the_procedures, Journal& a_journal)
        : link{a_link}, sdo{a_client}, sheet{a_sheet}, procedures{the_procedures}, journal{a_journal} {}
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    Link& link;
    SdoClient& sdo;
    const ConformSheet& sheet;
    const std::map<std::string, Procedure>& procedures;
    Journal& journal;
    Scope root{};
    Scope* scope{&root};
    const Step* at{nullptr};  ///< the step that runs now
    std::map<std::string, std::shared_ptr<const Watched>> watches;
    std::vector<std::string> turns;  ///< names of the current iterations of all loops around the step: `P = TPDO 2`
    unsigned depth{0};               ///< number of nested calls of procedures
    std::optional<bool> block_upload{};
    std::optional<bool> block_download{};

    std::uint8_t node() const { return sheet.node_id; }
};

/// Runs the steps in order. If a step throws an exception, `context.at` points to this step, or to the inner step that
/// threw.
void run_steps(const Steps& steps, Context& context);

/// Thrown by `next unless`: skips this iteration of the loop.
struct NextTurn {
    std::string reason;
};
/// Thrown by `return`: ends a procedure.
struct Returned {
    Value value;
};

}  // namespace canproof::host::conform
