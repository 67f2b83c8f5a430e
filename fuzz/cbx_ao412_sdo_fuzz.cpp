// SDO requests of any bytes, in any order, with time passing between them, to a whole CAN-CBX-AO412.
// Input: records of nine bytes, a time step of 16 ms each unit and eight bytes of request.

#include "firmware/devices/cbx_ao412.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/devices/memory.hpp"
#include "support/claims.hpp"
#include "support/require.hpp"

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t record_size = 9;
constexpr std::uint32_t request_id = 0x603;
constexpr std::uint32_t response_id = 0x583;

/// At most one answer a request, eight bytes, with a server's command specifier; frames on the device's own identifiers
/// only.
void check_answers(TransmitQueue& queue) {
    int answers = 0;
    while (!queue.empty()) {
        const Frame frame = queue.pop();
        require(!frame.extended && frame.length <= 8);
        if (frame.id == response_id) {
            ++answers;
            require(frame.length == 8 && (frame.data[0] >> 5U) <= 4U);
        }
    }
    require(answers <= 1);
}

}  // namespace

CANPROOF_FUZZ_CLAIMS(req::CO_SDO_015)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    host::Memory memory{1024};
    TransmitQueue queue;
    cbx_ao412::Device device{memory, queue, cbx_ao412::FactoryData{}};
    Instant now{};
    device.power_on(cbx_ao412::Inputs{}, now);
    while (!queue.empty()) {
        queue.pop();
    }
    for (; size >= record_size; data += record_size, size -= record_size) {
        now = now + milliseconds(16U * data[0]);
        device.advance(now);
        while (!queue.empty()) {
            queue.pop();
        }
        Frame request = data_frame(request_id, 8);
        std::copy(data + 1, data + record_size, request.data.begin());
        device.receive(request, now);
        check_answers(queue);
        for (const float volts : device.outputs().aout) {
            require(volts >= -10.2046F && volts <= 10.2046F);
        }
    }
    return 0;
}
