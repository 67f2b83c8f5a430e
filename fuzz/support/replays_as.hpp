// SPDX-License-Identifier: Apache-2.0
// Describes how the frames of an input are replayed: `canproof replay` of a device or of a data sheet.
#pragma once

#include <string>

#include "host/datasheet/write_eds.hpp"

namespace canproof::fuzz {

struct ReplaysAs {
    std::string arguments;  ///< arguments of `canproof replay` without the log: `cbx-ao412 --node 3`
    std::string eds;  ///< text of a data sheet; if not empty, the command is `canproof replay --eds FILE` followed by
                      ///< `arguments`
};

/// Targets that give frames to a device define this function with one of the macros below; the others do not define it.
[[gnu::weak]] ReplaysAs replays_as();

}  // namespace canproof::fuzz

#define CANPROOF_FUZZ_REPLAYS_AS(arguments_of_replay)        \
    canproof::fuzz::ReplaysAs canproof::fuzz::replays_as() { \
        return {arguments_of_replay, ""};                    \
    }

#define CANPROOF_FUZZ_REPLAYS_AS_PART(part_of_register, arguments_of_replay)           \
    canproof::fuzz::ReplaysAs canproof::fuzz::replays_as() {                           \
        return {arguments_of_replay, canproof::host::write_eds({}, part_of_register)}; \
    }
