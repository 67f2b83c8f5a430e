// SPDX-License-Identifier: Apache-2.0
// Mixes everything that affects PDOs, in any order: SDO writes to their parameters, RPDOs and other frames, remote
// frames, SYNCs, NMT commands, values that change in the device, and time. The slave is that of the conformance suite,
// node 5. Input: records of ten bytes: the event, its argument (length, number or milliseconds), and eight bytes of
// data.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/pdo_slave.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "fuzz/support/require.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/support/naive_pdo.hpp"

namespace {

using namespace canproof;
using fuzz::Pdo;
using fuzz::pdo_count;
using fuzz::require;
using Slave = fuzz::PdoSlave;
using Values = fuzz::PdoValues;
using naive_pdo::Bytes;

constexpr std::size_t record_size = 10;

/// Returns whether a value is within its limits: 2200h from -100 to 100, 2202h from -10 to 10. Other entries have no
/// limits.
bool fits(const naive_pdo::Mappable& line, std::uint64_t value) {
    if (line.index == 0x2200) {
        const auto number = static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
        return number >= -100 && number <= 100;
    }
    if (line.index == 0x2202) {
        const float number = bit_cast<float>(static_cast<std::uint32_t>(value));
        return std::isfinite(number) && number >= -10.0F && number <= 10.0F;
    }
    return true;
}

/// Returns whether CiA 301 (7.3.5) reserves this identifier, so that no PDO may use it.
bool is_kept_for_others(std::uint32_t id) {
    return id <= 0x07F || (id >= 0x101 && id <= 0x180) || (id >= 0x581 && id <= 0x5FF) ||
           (id >= 0x601 && id <= 0x67F) || (id >= 0x6E0 && id <= 0x6FF) || id >= 0x701;
}

/// Returns whether one of the first `before` TPDOs is valid and has this identifier.
bool is_transmitted(const Slave& slave, std::uint32_t id, unsigned before) {
    for (unsigned number = 0; number < before; ++number) {
        if (slave.tpdo(number).is_valid() && slave.tpdo(number).id() == id) {
            return true;
        }
    }
    return false;
}

void check_parameters(Slave& slave) {
    for (unsigned number = 0; number < pdo_count; ++number) {
        const Pdo& pdo = slave.tpdo(number);
        require(naive_pdo::total_bits(pdo.mapping) <= 64 && pdo.mapping.size() <= 8);
        require(pdo.type <= 240 || (pdo.type >= 252 && pdo.type <= 255));
        require(!pdo.is_valid() || (!is_kept_for_others(pdo.id()) && !is_transmitted(slave, pdo.id(), number)));
    }
    for (unsigned number = 0; number < pdo_count; ++number) {
        const Pdo& pdo = slave.rpdo(number);
        require(naive_pdo::total_bits(pdo.mapping) <= 64 && pdo.mapping.size() <= 8);
        require(pdo.type <= 240 || (pdo.type >= 254 && pdo.type <= 255));
        require(!pdo.is_valid() || (!is_kept_for_others(pdo.id()) && !is_transmitted(slave, pdo.id(), pdo_count)));
    }
    require(fits({0x2200, 0, 16}, slave.value(0x2200, 0)) && fits({0x2202, 0, 32}, slave.value(0x2202, 0)));
    for (const unsigned index : {0x2002U, 0x2003U}) {
        for (unsigned sub = 1; sub <= 8; ++sub) {
            require(slave.value(index, sub) <= 1);
        }
    }
}

/// The settings of the dictionary that determine which frames the node may send. A frame that is sent during a step
/// must match the settings before the step or after it.
struct Settings {
    std::array<Pdo, pdo_count> tpdos;
    bool operational{false};
    std::uint32_t sync_id{0};

    /// Reads the settings. Keeps its allocated memory for the next input.
    void read(Slave& slave) {
        operational = slave.is_operational();
        sync_id = static_cast<std::uint32_t>(slave.value(0x1005, 0)) & 0x7FF;
        for (unsigned number = 0; number < pdo_count; ++number) {
            tpdos[number] = slave.tpdo(number);
        }
    }
    bool has(const Frame& frame) const {
        bool found = false;
        for (const Pdo& pdo : tpdos) {
            found = found || (pdo.is_valid() && pdo.id() == frame.id && !pdo.mapping.empty() &&
                              naive_pdo::total_bytes(pdo.mapping) == frame.length);
        }
        return found;
    }
};

/// Checks the identifiers of the frames that were sent. The node may always send SDO, EMCY, error control and SYNC
/// frames. Every other frame must be a valid TPDO of an operational node.
void check_frames(Slave& slave, const Settings& before, const Settings& after) {
    const bool operational = before.operational || after.operational;
    for (const Frame& frame : slave.drain()) {
        require(!frame.extended && !frame.remote && frame.length <= 8);
        const bool service = frame.id == 0x585 || frame.id == 0x705 || frame.id == before.sync_id ||
                             frame.id == after.sync_id || slave.has_emcy_id(frame.id);
        require(service || (operational && (before.has(frame) || after.has(frame))));
    }
}

/// Returns the values expected after a frame. RPDOs of transmission types 254 and 255 set the values as in the naive
/// model; other RPDOs set nothing before a SYNC.
Values expected_after(Slave& slave, const Frame& frame) {
    Values values = slave.values();
    const Bytes data(frame.data.begin(), frame.data.begin() + frame.length);
    for (unsigned number = 0; number < pdo_count && slave.is_operational(); ++number) {
        const Pdo& pdo = slave.rpdo(number);
        if (pdo.is_valid() && pdo.id() == frame.id && pdo.type >= 254) {
            values = naive_pdo::received(values, pdo.mapping, data, fits);
        }
    }
    return values;
}

void receive_rpdo(Slave& slave, std::uint32_t id, std::uint8_t length, const std::uint8_t* data) {
    Frame frame = data_frame(id, length);
    std::copy_n(data, length, frame.data.begin());
    slave.pass(0);
    Values expected = expected_after(slave, frame);
    slave.receive(frame);
    Values found = slave.values();
    expected.erase({0x1001, 0});  // ignores 1001h (error register), because a frame that is too short raises an error
    found.erase({0x1001, 0});
    require(found == expected);
}

/// Requests a TPDO by a remote frame. A TPDO of transmission type 253 must answer with the present values. A TPDO of
/// type 254 or 255 without an inhibit time must do so, too.
void request_tpdo(Slave& slave, unsigned number) {
    const Pdo& pdo = slave.tpdo(number);
    Frame frame = data_frame(pdo.id(), 0);
    frame.remote = true;
    slave.pass(0);
    slave.drain();
    slave.forget();
    const bool answers = slave.is_operational() && pdo.is_valid() && pdo.has_remote() && !pdo.mapping.empty() &&
                         pdo.type >= 253 && (pdo.type == 253 || slave.value(0x1800 + number, 3) == 0);
    slave.receive(frame);
    const Bytes expected = naive_pdo::packed(pdo.mapping, slave.values());
    bool answered = false;
    for (const Frame& sent : slave.drain()) {
        answered =
            answered || (sent.id == pdo.id() && Bytes(sent.data.begin(), sent.data.begin() + sent.length) == expected);
    }
    require(!answers || answered);
}

void step(Slave& slave, const std::uint8_t* record) {
    const std::uint8_t how = record[1];
    const std::uint8_t* const data = record + 2;
    const auto length = static_cast<std::uint8_t>(std::min(how & 0x0F, 8));
    Frame frame{};
    switch (record[0] % 10U) {
        case 0:
        case 1:
        case 2:
            frame = data_frame(0x605, 8);
            std::copy_n(data, 8, frame.data.begin());
            slave.receive(frame);
            break;
        case 3:
            receive_rpdo(slave, slave.rpdo((how >> 4U) % pdo_count).id(), length, data);
            break;
        case 4:
            frame = data_frame(read_u16(ByteView{data, 2}, 0) & 0x7FFU, length);
            std::copy_n(data, length, frame.data.begin());
            frame.remote = (how & 0x80U) != 0;
            frame.extended = (how & 0x40U) != 0;
            // records of another kind send NMT commands, and another fuzz target tests LSS
            if (frame.id != 0 && frame.id != 0x7E5) {
                slave.receive(frame);
            }
            break;
        case 5:
            request_tpdo(slave, how % pdo_count);
            break;
        case 6:
            frame = data_frame(static_cast<std::uint32_t>(slave.value(0x1005, 0)) & 0x7FFU, how & 1U);
            frame.data[0] = data[0];
            slave.receive(frame);
            break;
        case 7: {
            constexpr std::array<std::uint8_t, 4> commands{0x01, 0x01, 0x80, 0x82};
            frame = data_frame(0, 2);
            frame.data[0] = commands[how % commands.size()];
            slave.receive(frame);
            break;
        }
        case 8:
            slave.set_byte(static_cast<std::uint8_t>(1 + how % 8), data[0]);
            break;
        default:
            slave.pass(how);
            break;
    }
}

}  // namespace

CANPROOF_FUZZ_REPLAYS_AS_PART(test::slave_part(), "--node 5")
CANPROOF_FUZZ_CLAIMS(req::CO_PDO_001, req::CO_PDO_011, req::CO_PDO_016, req::CO_PDO_045, req::CO_PDO_046,
                     req::CO_PDO_026, req::CO_PDO_059, req::CO_PDO_027, req::CO_PDO_028)
CANPROOF_FUZZ_RECORDS(record_size)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Slave slave;
    static Settings settings;
    static Settings after;
    fuzz::begin_checks(data, size);
    slave.restart();
    slave.has_changed();
    settings.read(slave);
    for (; size >= record_size; data += record_size, size -= record_size) {
        slave.forget();
        step(slave, data);
        require(slave.is_idle());
        if (slave.has_changed()) {
            after.read(slave);
            check_frames(slave, settings, after);
            check_parameters(slave);
            std::swap(settings, after);
        } else {
            settings.operational = settings.operational || slave.is_operational();
            check_frames(slave, settings, settings);
            settings.operational = slave.is_operational();
        }
    }
    return 0;
}
