// A whole AX060805: any frames, any physical inputs, time and power cycles, in any order.
// Input: records of ten bytes: what happens, which (identifier, input, or time), and eight bytes of data.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "firmware/devices/ax060805.hpp"
#include "generated/ax060805/requirements.hpp"
#include "host/devices/memory.hpp"
#include "support/claims.hpp"
#include "support/record_mutator.hpp"
#include "support/require.hpp"

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t record_size = 10;

class World {
  public:
    World() { power_on(); }

    void record(const std::uint8_t* data) {
        const std::uint8_t which = data[1];
        switch (data[0] % 8) {
            case 0:
            case 1:
                receive(0x600U + node(), 8, data + 2);
                break;
            case 2:
                receive(0x7E5, which % 9U, data + 2);
                break;
            case 3:
                receive(0x000, which % 3U, data + 2);
                break;
            case 4:
                receive(read_u16(ByteView{data + 2, 2}, 0) & 0x7FFU, which % 9U, data + 2);
                break;
            case 5:
                set_input(which, data + 2);
                break;
            case 6:
                pass(milliseconds(read_u16(ByteView{data + 2, 2}, 0) % 10000U));
                break;
            default:
                if (which % 4U == 0) {
                    memory_.cut_power_after(data[2]);
                    receive(0x600U + node(), 8, data + 2);
                    memory_.restore_power();
                    power_on();
                } else {
                    receive(0x200U + node(), 6, data + 2);
                }
        }
        check_objects();
    }

  private:
    std::uint32_t node() const { return device_->node_id() & 0x7FU; }

    void power_on() {
        device_.reset();
        queue_ = std::make_unique<TransmitQueue>();
        device_ = std::make_unique<ax060805::Device>(memory_, *queue_, ax060805::FactoryData{});
        device_->power_on(inputs_, now_);
        drain(0);
    }

    void receive(std::uint32_t id, std::size_t length, const std::uint8_t* data) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(length));
        std::copy_n(data, length, frame.data.begin());
        const std::uint32_t before = node();
        device_->receive(frame, now_);
        drain(id == 0x600U + before ? 1 : 0);
    }

    void pass(Duration time) {
        const Instant end = now_ + time;
        for (int steps = 0; device_->next_deadline() <= end; ++steps) {
            require(steps < 80000);  // 10 s of samples each 5 ms, filters, heartbeats and four event timers each 1 ms
            now_ = device_->next_deadline() < now_ ? now_ : device_->next_deadline();
            device_->advance(now_);
            drain(1);  // an SDO transfer may run into its time-out
        }
        now_ = end;
    }

    void set_input(std::uint8_t which, const std::uint8_t* data) {
        float number = 0.0F;
        std::memcpy(&number, data, sizeof number);
        switch (which % 10U) {
            case 0:
                inputs_.acceleration_x = number;
                break;
            case 1:
                inputs_.acceleration_y = number;
                break;
            case 2:
                inputs_.acceleration_z = number;
                break;
            case 3:  // an attitude
                inputs_.acceleration_x = static_cast<float>(static_cast<std::int8_t>(data[0])) / 128.0F;
                inputs_.acceleration_y = static_cast<float>(static_cast<std::int8_t>(data[1])) / 128.0F;
                inputs_.acceleration_z = static_cast<float>(static_cast<std::int8_t>(data[2])) / 128.0F;
                break;
            case 4:
                inputs_.accelerometer_fault = (data[0] & 1U) != 0U;
                break;
            case 5:
                inputs_.sensor_temperature = number;
                break;
            case 6:
                inputs_.processor_temperature = number;
                break;
            case 7:
                inputs_.supply_voltage = number;
                break;
            case 8:
                inputs_.can_state = data[0] % 4U;
                break;
            default:
                inputs_.can_overrun = (data[0] & 1U) != 0U;
        }
        device_->set_inputs(inputs_, now_);
        drain(0);
    }

    /// Frames are well formed and on identifiers that the device may use; `answers` SDO responses at most.
    void drain(int answers) {
        while (!queue_->empty()) {
            const Frame frame = queue_->pop();
            require(!frame.extended && !frame.remote && frame.length <= 8 && frame.id <= 0x7FF && frame.id != 0);
            if (frame.id == 0x580U + node()) {
                --answers;
                require(frame.length == 8);
            }
        }
        require(answers >= 0 || device_->node_id() == 255);
    }

    /// What always holds, whatever happened: every value within its limits (1003h:0 has those of a write).
    void check_objects() const {
        const ObjectDictionary& objects = device_->objects();
        for (const ObjectRow& object : objects.tables().objects) {
            for (std::size_t i = 0; i < object.count; ++i) {
                const EntryRef entry{&objects.tables().entries[object.first_entry + i], object.index};
                require(entry.is(0x1003, 0) || objects.check_value(entry, objects.value(entry)) == AbortCode::none);
            }
        }
        require(objects.read(0x1003, 0) <= 4 && objects.read(0x1001, 0) <= 1);
        require(objects.read(0x4020, 0) <= 2 && objects.read(0x2300, 0) == 0);
    }

    host::Memory memory_{4096};
    std::unique_ptr<TransmitQueue> queue_;
    ax060805::Inputs inputs_{};
    Instant now_{};
    std::unique_ptr<ax060805::Device> device_;
};

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::INC_FV_002, req::INC_BIN_007, req::INC_INSTALL_005)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    World world;
    for (; size >= record_size; data += record_size, size -= record_size) {
        world.record(data);
    }
    return 0;
}
