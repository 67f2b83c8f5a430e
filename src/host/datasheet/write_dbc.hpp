// SPDX-License-Identifier: Apache-2.0
// Writes the frames of a device as a DBC file: NMT, SYNC, EMCY, PDOs with their default mapping, SDO, heartbeat.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the DBC file of the device at `node_id`, 1 to 127. Leaves out messages that are switched off by default, and
/// messages whose identifier another message uses; the comment of the file names these messages. EMCY without 1014h
/// COB-ID EMCY gets the identifier 80h + node-ID. In SDO frames, the signal Object is the multiplexor, with the value
/// index + 65536 × sub-index. Each entry of up to 4 bytes is a signal: in the request if it can be written, in the
/// response if it can be read. With Command 80h the data are an abort code. Longer entries, LSS and node guarding
/// requests have no signals.
std::string write_dbc(const Part& part, unsigned node_id);

}  // namespace canproof::host
