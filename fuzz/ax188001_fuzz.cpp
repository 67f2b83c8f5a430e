// A whole AX188001: any frames, any physical inputs, time and power cycles, in any order.
// Input: records of ten bytes: what happens, which (identifier, input, or time), and eight bytes of data.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "firmware/devices/ax188001.hpp"
#include "generated/ax188001/requirements.hpp"
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
                    receive(0x600U + node(), 8, data + 2);
                }
        }
        check_objects();
    }

  private:
    std::uint32_t node() const { return device_->node_id() & 0x7FU; }

    void power_on() {
        device_.reset();
        queue_ = std::make_unique<TransmitQueue>();
        device_ = std::make_unique<ax188001::Device>(memory_, *queue_, ax188001::FactoryData{});
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
            require(steps < 20000);  // 10 s of heartbeats each 10 ms, event timers each 1 ms, readings each 165 ms
            now_ = std::max(now_.us, device_->next_deadline().us) == now_.us ? now_ : device_->next_deadline();
            device_->advance(now_);
            drain(1);  // an SDO transfer may run into its time-out
        }
        now_ = end;
    }

    void set_input(std::uint8_t which, const std::uint8_t* data) {
        const std::size_t channel = which & 1U;
        float number = 0.0F;
        std::memcpy(&number, data, sizeof number);
        switch ((which >> 1U) % 8U) {
            case 0:
                inputs_.tc_microvolts[channel] = number;
                break;
            case 1:
                inputs_.tc_open[channel] = (data[0] & 1U) != 0U;
                break;
            case 2:
                inputs_.tc_hum[channel] = number;
                inputs_.mains_frequency = data[4];
                break;
            case 3:
                inputs_.cold_junction = number;
                break;
            case 4:
                inputs_.cpu_temperature = number;
                break;
            case 5:
                inputs_.supply = number;
                break;
            case 6:
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
            require(!frame.extended && !frame.remote && frame.length <= 8 && frame.id <= 0x7FF);
            if (frame.id == 0x580U + node()) {
                --answers;
                require(frame.length == 8);
            }
            if (frame.id == 0) {  // only 5555h = 2 sends an NMT command
                require(frame.length == 2 && frame.data[0] == 1 && frame.data[1] == 0);
            }
        }
        require(answers >= 0 || device_->node_id() == 255);
    }

    /// What always holds, whatever happened (1.1, 3.2.4, 3.3.6, 3.4.13 to 3.4.19).
    void check_objects() const {
        for (std::uint8_t sub = 1; sub <= 2; ++sub) {
            const auto status = read(0x6150, sub);
            require(status == 0 || (status >= 2 && status <= 5));
            const auto low = word(0x4000, sub);
            const auto high = word(0x4010, sub);
            const auto shutdown = word(0x4020, sub);
            require(low >= -2730 && low <= high - 100 && high <= shutdown - 100 && shutdown <= 17350);
            check_values(0x6100, 0x7130, sub);
        }
        check_values(0x2100, 0x2130, 0);
        require(read(0x5042, 1) <= read(0x5041, 1) && read(0x5042, 2) <= read(0x5041, 2));
        require(read(0x5041, 3) <= read(0x5042, 3) && read(0x5042, 3) <= read(0x5042, 2));
        require(read(0x1003, 0) <= 9 && read(0x1001, 0) <= 1);
        require(read(0x1001, 0) == 1 || read(0x1003, 0) == 0);
    }
    /// A sentinel in the process value goes with FFC00000h in the field value, and the other way round.
    void check_values(std::uint16_t field_index, std::uint16_t process_index, std::uint8_t sub) const {
        const std::uint32_t bits = read(field_index, sub);
        const std::uint32_t value = read(process_index, sub);
        const bool sentinel = value == 0xFFFF || value == 0xFE00;
        require(sentinel == (bits == 0xFFC00000));
        if (!sentinel) {
            const auto celsius = bit_cast<float>(bits);
            require(celsius >= -270.01F && celsius <= 1820.01F);
        }
    }
    std::uint32_t read(std::uint16_t index, std::uint8_t sub) const { return device_->objects().read(index, sub); }
    int word(std::uint16_t index, std::uint8_t sub) const { return static_cast<std::int16_t>(read(index, sub)); }

    host::Memory memory_{1024};
    std::unique_ptr<TransmitQueue> queue_;
    ax188001::Inputs inputs_{};
    Instant now_{};
    std::unique_ptr<ax188001::Device> device_;
};

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::TCS_VAL_007, req::TCS_LIM_008, req::TCS_FD_006)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    World world;
    for (; size >= record_size; data += record_size, size -= record_size) {
        world.record(data);
    }
    return 0;
}
