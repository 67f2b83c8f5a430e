// The frames of a device as a DBC file: NMT, SYNC, EMCY, PDOs as mapped by default, SDO, heartbeat.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// The device at `node_id`, 1 to 127. PDOs that are switched off by default, and identifiers that another message has
/// already, are left out and named in the comment of the file. EMCY without 1014h (COB-ID EMCY) is at 80h + node-ID.
/// SDO: the signal Object is the multiplexor, index and sub-index as they stand in the frame, index + 65536 x
/// sub-index; each entry of up to 4 bytes is a signal there, in the request where it can be written, in the response
/// where it can be read. With Command 80h the data are an abort code. Longer entries, LSS and node guarding requests
/// have no signals.
std::string write_dbc(const Part& part, unsigned node_id);

}  // namespace canproof::host
