#include "host/devices/generic_device.hpp"

namespace canproof::host {

namespace {

constexpr std::uint8_t generic_error = 0x01;
constexpr std::uint8_t communication_error = 0x11;  // bits 0 and 4 of 1001h

NodeProfile profile_of(const Part& part) {
    NodeProfile profile;
    profile.limit_abort = part.info.limit_abort == "range" ? LimitAbort::range : LimitAbort::high_low;
    profile.error_list = part.info.error_list == "active" ? ErrorList::active : ErrorList::history;
    return profile;
}

}  // namespace

ErrorTable standard_errors() {
    ErrorTable table{};
    const auto tell = [&table](ErrorId error, std::uint16_t code, std::uint8_t bits) {
        table[static_cast<std::size_t>(error)] = ErrorRow{code, bits, true, true};
    };
    tell(ErrorId::can_overrun, 0x8110, communication_error);
    tell(ErrorId::error_passive, 0x8120, communication_error);
    tell(ErrorId::guard_or_heartbeat, 0x8130, communication_error);
    tell(ErrorId::bus_off_recovered, 0x8140, communication_error);
    tell(ErrorId::sync_length, 0x8240, communication_error);
    tell(ErrorId::rpdo_length, 0x8210, communication_error);
    tell(ErrorId::rpdo_timeout, 0x8250, communication_error);
    tell(ErrorId::internal_software, 0x6100, generic_error);
    tell(ErrorId::stored_set_checksum, 0x6300, generic_error);
    return table;
}

GenericDevice::GenericDevice(const Part& part, NonVolatileMemory& memory, TransmitQueue& queue)
    : rows_{make_rows(part)},
      tables_{rows_.tables()},
      image_(rows_.layout.image.size()),
      objects_{tables_, MutableBytes{image_.data(), image_.size()},
               part.info.limit_abort == "range" ? LimitAbort::range : LimitAbort::high_low},
      errors_{standard_errors()},
      node_{objects_, memory, queue, *this, errors_, profile_of(part)} {}

}  // namespace canproof::host
