// SPDX-License-Identifier: Apache-2.0
// Writes the frames of a device as a DBC file: NMT, SYNC, EMCY, PDOs with their default mapping, SDO, heartbeat.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the DBC of the device at `node_id`, 1 to 127. It leaves out PDOs that are switched off by default, and
/// messages whose identifier is already used; the comment of the file names them. EMCY without 1014h (COB-ID EMCY) has
/// the identifier 80h + node-ID. In SDO frames, the signal Object is the multiplexor: index and sub-index as in the
/// frame, index + 65536 x sub-index. Each entry of up to 4 bytes is a signal: in the request if it can be written, in
/// the response if it can be read. With Command 80h the data are an abort code. Longer entries, LSS and node guarding
/// requests have no signals.
std::string write_dbc(const Part& part, unsigned node_id);

}  // namespace canproof::host
