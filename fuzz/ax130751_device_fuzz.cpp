// A whole AX130751 under anything that can happen to it: SDO writes to each of its entries, any frames, any supply,
// temperature and load, power cycles, time between them.
// Input: records of twelve bytes: what happens, milliseconds before it, ten bytes for it.
#include <optional>

#include "firmware/devices/ax130751.hpp"
#include "generated/ax130751/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/devices/memory.hpp"
#include "support/claims.hpp"
#include "support/require.hpp"

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t record_size = 12;
constexpr std::size_t most_records = 200;  // longer inputs find nothing that shorter ones do not
constexpr std::size_t memory_size = 8192;

/// 1.3 Table 3, section 4: no output leaves the range of any type, and without a supply nothing is driven.
void check_outputs(const ax130751::Outputs& outputs, const ax130751::Inputs& inputs, bool settled) {
    const bool shut = settled && (inputs.supply < 7.0F || inputs.supply > 39.0F);
    require(outputs.relay_nc != outputs.relay_no);
    require(!(shut && outputs.relay_nc));
    for (std::size_t i = 0; i < 2; ++i) {
        const float volts = outputs.out_voltage[i];
        require(volts >= -10.0F && volts <= 12.0F);
        require(outputs.out_current[i] >= 0.0F && outputs.out_current[i] <= 24.0F);
        require(outputs.out_duty[i] >= 0.0F && outputs.out_duty[i] <= 100.0F);
        require(outputs.out_frequency[i] >= 0.0F && outputs.out_frequency[i] <= 30000.0F);
        require(outputs.out_level[i] == 0.0F || outputs.out_level[i] == 5.0F || outputs.out_level[i] == 12.0F);
        if (shut) {
            require(volts == 0.0F && outputs.out_current[i] == 0.0F && !outputs.out_on[i]);
        }
    }
}

class Bench {
  public:
    Bench() { power_cycle(); }

    void play(const std::uint8_t* record) {
        pass(record[1]);
        happen(record[0], record + 2);
        check_outputs(device_->outputs(), inputs_, false);
    }
    /// Long enough for the blocks to see what came last.
    void settle() {
        pass(5);
        check_outputs(device_->outputs(), inputs_, true);
    }

  private:
    void power_cycle() {
        queue_ = TransmitQueue{};
        device_.emplace(memory_, queue_, ax130751::FactoryData{});
        device_->power_on(inputs_, now_);
        empty();
    }
    void pass(unsigned ms) {
        const Instant end = now_ + milliseconds(ms);
        device_->advance(end);
        now_ = end;
        empty();
    }
    void empty() {
        while (!queue_.empty()) {
            const Frame frame = queue_.pop();
            require(!frame.extended && frame.length <= max_frame_length);
        }
    }

    void happen(unsigned what, const std::uint8_t* data) {
        switch (what % 8U) {
            case 0:
                return write_entry(data);
            case 1:
                return send(0x600U + device_->node_id(), 8, data);
            case 2:
                return send(0x200U + 0x100U * (data[0] % 4U) + device_->node_id(), data[1] % 9U, data + 2);
            case 3:
                return command(data[0]);
            case 4:
                return supply(data);
            case 5:
                return send((data[0] + 256U * data[1]) & 0x7FFU, data[2] % 8U, data + 3);
            case 6:
                return send(0x7E5U, 8, data);
            default:
                return power_cycle();
        }
    }
    void send(std::uint32_t id, unsigned length, const std::uint8_t* data) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(length));
        std::copy(data, data + length, frame.data.begin());
        device_->receive(frame, now_);
        int answers = 0;
        while (!queue_.empty()) {
            const Frame answer = queue_.pop();
            require(!answer.extended && answer.length <= max_frame_length);
            answers += answer.id == 0x580U + device_->node_id() ? 1 : 0;
        }
        require(answers <= 1);
    }
    /// An expedited write of the right length to one of the entries, so that values matter and not addresses.
    void write_entry(const std::uint8_t* data) {
        const auto& tables = generated::ax130751::tables;
        const std::size_t chosen = (data[0] | (unsigned{data[1]} << 8U)) % tables.entries.count;
        for (const ObjectRow& object : tables.objects) {
            const std::size_t first = object.first_entry;
            if (chosen < first || chosen >= first + object.count) {
                continue;
            }
            const EntryRow& entry = tables.entries[chosen];
            std::uint8_t request[8]{};
            request[0] = static_cast<std::uint8_t>(0x23U | ((4U - entry.size) << 2U));
            request[1] = static_cast<std::uint8_t>(object.index);
            request[2] = static_cast<std::uint8_t>(object.index >> 8U);
            request[3] = entry.subindex;
            std::copy(data + 2, data + 2 + entry.size, request + 4);
            send(0x600U + device_->node_id(), 8, request);
        }
    }
    void command(unsigned chosen) {
        constexpr std::uint8_t commands[]{0x01, 0x02, 0x80, 0x81, 0x82};
        const std::uint8_t data[2]{commands[chosen % 5U], device_->node_id()};
        send(0x000U, 2, data);
    }
    void supply(const std::uint8_t* data) {
        inputs_.supply = static_cast<float>(data[0] | (unsigned{data[1]} << 8U)) / 1000.0F;
        inputs_.cpu_temperature = static_cast<float>(data[2]) - 50.0F;
        inputs_.load = {static_cast<float>(data[3]) * 10.0F, static_cast<float>(data[4])};
        inputs_.can_state = data[5] % 4U;
        inputs_.can_overrun = (data[6] & 1U) != 0U;
        device_->set_inputs(inputs_, now_);
        empty();
    }

    host::Memory memory_{memory_size};
    TransmitQueue queue_;
    ax130751::Inputs inputs_{};
    Instant now_{};
    std::optional<ax130751::Device> device_;
};

}  // namespace

CANPROOF_FUZZ_CLAIMS(req::AOR_OUT_016, req::AOR_DIAG_008, req::AOR_RELAY_001, req::CO_SDO_015)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bench bench;
    for (std::size_t i = 0; i < most_records && size >= record_size; ++i, data += record_size, size -= record_size) {
        bench.play(data);
    }
    bench.settle();
    return 0;
}
