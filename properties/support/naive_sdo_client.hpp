// SPDX-License-Identifier: Apache-2.0
// An SDO client that always sends the request that the naive SDO server expects next, so that transfers are completed.
#pragma once

#include <initializer_list>

#include "properties/support/naive_sdo_server.hpp"

namespace canproof::naive {

inline Message message(unsigned command, std::initializer_list<unsigned> rest = {}) {
    Message m{static_cast<std::uint8_t>(command)};
    std::transform(rest.begin(), rest.end(), m.begin() + 1,
                   [](unsigned byte) { return static_cast<std::uint8_t>(byte); });
    return m;
}

/// Returns a request with `command` and seven bytes of data, which count up from `next`.
inline Message with_data(unsigned command, std::uint8_t& next) {
    Message m = message(command);
    for (std::size_t i = 1; i < m.size(); ++i) {
        m[i] = next;
        next = static_cast<std::uint8_t>(next == 255 ? 1 : next + 1);
    }
    return m;
}

/// Returns the request that the server expects next. If `ends` is true, a segment is marked as the last one, and its
/// last `unused` (0 to 7) bytes contain no data. `next` is the next byte of data; it counts up.
inline Message obedient(const Server& server, std::uint8_t& next, bool ends, unsigned unused) {
    switch (server.doing()) {
        case Server::Doing::download:
            return with_data(server.next_toggle() + 2 * (ends ? unused : 0) + (ends ? 1 : 0), next);
        case Server::Doing::upload:
            return message(0x60U + server.next_toggle());
        case Server::Doing::block_download:
            return with_data(server.next_sequence() + (ends ? 0x80U : 0U), next);
        case Server::Doing::block_download_end: {
            Bytes data = server.received();
            data.resize(data.size() - unused);
            const unsigned crc = crc16(data);
            return message(0xC1 + 4 * unused, {crc % 256U, crc / 256U});
        }
        case Server::Doing::block_start:
            return message(0xA3);
        case Server::Doing::block_upload:
            return message(0xA2, {static_cast<unsigned>(server.pieces_out()), 127});
        case Server::Doing::block_end:
            return message(0xA1);
        case Server::Doing::nothing:
        default:
            return message(0x40, {0x07, 0x20});
    }
}

}  // namespace canproof::naive
