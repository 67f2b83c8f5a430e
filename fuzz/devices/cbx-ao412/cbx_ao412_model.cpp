// SPDX-License-Identifier: Apache-2.0
// Runs the naive model of the CAN-CBX-AO412 (a second, simple implementation) beside the device. Compares voltages,
// LEDs, all frames, 1001h (error register), 1003h (error list), and the objects of the outputs.
#include "fuzz/devices/cbx-ao412/cbx_ao412_unit.hpp"
#include "fuzz/support/beside_model.hpp"
#include "fuzz/support/expedited_write.hpp"
#include "properties/devices/cbx-ao412/naive_comparison.hpp"

namespace {

using namespace canproof;

class Model {
  public:
    static constexpr std::uint64_t longest_wait_ms = 1500;
    static constexpr unsigned further_events = 40;
    static constexpr std::uint64_t longest_run_ms = 6000;

    explicit Model(const cbx_ao412::Device&) {}

    /// Gives the four outputs different settings, and lets the device monitor a heartbeat.
    template <typename Run>
    static void begin(Run& run, fuzz::Choices&) {
        const auto write = [&run](unsigned index, unsigned sub, unsigned size, std::uint32_t bits) {
            run.receive(fuzz::write_request(cbx_ao412::Inputs{}.switch_low, index, sub, size, bits));
        };
        for (unsigned sub = 1; sub <= 4; ++sub) {
            write(0x6443, sub, 1, sub % 3);
            write(0x6444, sub, 4, 0x10005000U * sub);
            write(0x6411, sub, 2, 0x0777U * sub);
            write(0x2404, sub, 2, 40U * sub);
            write(0x2405, sub, 2, 777U * sub);
        }
        write(0x1016, 1, 4, 0x310000U | 400U);
    }
    /// Returns an NMT command, RPDO2, SYNC, the monitored heartbeat, or a guarding request.
    static Frame usual_frame(unsigned node, unsigned which, const std::uint8_t* data) {
        Frame frame = data_frame(0, 2);
        constexpr std::array<std::uint8_t, 8> commands{0x01, 0x01, 0x01, 0x80, 0x02, 0x81, 0x82, 0x81};
        switch (which % 8U) {
            case 0:
            case 1:
                frame = data_frame(0x300U + node, 8);
                std::copy_n(data, 8, frame.data.begin());
                return frame;
            case 2:
                return data_frame(0x080, 0);
            case 3:
            case 4:
                frame = data_frame(0x731, 1);
                frame.data[0] = 5;
                return frame;
            case 5:
                frame = data_frame(0x700U + node, 0);
                frame.remote = true;
                return frame;
            default:
                frame.data[0] = commands[data[0] % commands.size()];
                return frame;
        }
    }
    static const char* ends() { return nullptr; }

    static void finish(const cbx_ao412::Device&) {}
    void power_on(const cbx_ao412::Inputs& inputs, std::uint64_t now_ms) {
        model_.power_on(naive_ao4::terminals_of(inputs), now_ms);
    }
    void set_inputs(const cbx_ao412::Inputs& inputs) { model_.set_terminals(naive_ao4::terminals_of(inputs)); }
    void pass(std::uint64_t ms) { model_.pass(ms); }

    /// Starts or ends a failure, or changes the number of lost frames or the state of the CAN controller; rarely
    /// changes a switch.
    static void put_usual_input(cbx_ao412::Inputs& inputs, unsigned which, const std::uint8_t* data) {
        const bool present = (data[0] & 1U) != 0;
        switch (which % 8U) {
            case 0:
            case 1:
                inputs.internal_fault = present;
                return;
            case 2:
                inputs.hardware_fault = present;
                return;
            case 3:
                inputs.can_overrun = present;
                return;
            case 4:
                (present ? inputs.switch_low : inputs.switch_baud) = data[1] % 16U;
                return;
            default:
                inputs.can_state = data[0] % 4U;
                return;
        }
    }
    static const char* unknown(const cbx_ao412::Inputs& inputs) {
        const bool is_position = inputs.switch_high <= 15 && inputs.switch_low <= 15 && inputs.switch_baud <= 15;
        return !is_position           ? "a switch has 16 positions"
               : inputs.can_state > 3 ? "no CAN controller has this state"
                                      : nullptr;
    }
    const char* unknown(const Frame& frame, const cbx_ao412::Device& device) const {
        const unsigned node = device.node_id();
        if (frame.extended || frame.remote) {
            return nullptr;
        }
        if (frame.id == 0x600U + node) {
            const auto write = fuzz::expedited_write(device.objects(), frame);
            return write ? unknown_write(*write, node) : "sdo_server compares other SDO requests";
        }
        if (frame.id > 0x700U && frame.id <= 0x77FU) {
            const bool is_state = frame.data[0] == 4 || frame.data[0] == 5 || frame.data[0] == 127;
            return frame.length == 1 && is_state && frame.id != 0x700U + node
                       ? nullptr
                       : "error_control compares other heartbeats";
        }
        return nullptr;
    }
    void receive(const Frame& frame) {
        if (frame.extended) {
            return;  // the device has identifiers of 11 bits only
        }
        if (frame.remote) {
            return model_.ask(frame.id);
        }
        std::vector<unsigned> data(frame.data.begin(), frame.data.begin() + frame.length);
        if (frame.id == 0x600U + model_.node()) {
            const std::size_t size = 4U - ((data[0] >> 2U) & 3U);
            std::fill(data.begin() + 4 + static_cast<std::ptrdiff_t>(size), data.end(), 0U);
        }
        model_.receive(frame.id, data);
    }

    void compare(const cbx_ao412::Device& device, const std::vector<Frame>& said, std::uint64_t now_ms) {
        fuzz::require_frames(fuzz::timed(said, now_ms), model_.take_sent());
        naive_ao4::compare_outputs(device, model_, [](bool holds, const char* what) { fuzz::require(holds, what); });
        if (model_.runs()) {
            naive_ao4::compare_objects(device, model_,
                                       [](bool holds, const char* what) { fuzz::require(holds, what); });
        }
    }

  private:
    static bool is_of_an_output(const fuzz::ExpeditedWrite& write) {
        constexpr std::array<unsigned, 5> known{0x2404, 0x2405, 0x6411, 0x6443, 0x6444};
        return write.sub() >= 1 && write.sub() <= 4 &&
               std::find(known.begin(), known.end(), write.index()) != known.end();
    }
    static const char* unknown_write(const fuzz::ExpeditedWrite& write, unsigned node) {
        const std::uint32_t bits = write.bits;
        const auto known_if = [](bool known, const char* why) { return known ? nullptr : why; };
        switch (write.address()) {
            case 0x100300:
            case 0x100C00:
            case 0x100D00:
            case 0x101700:
            case 0x102901:
            case 0x1F8000:
                return nullptr;
            case 0x101001:
                return known_if(bits == 0x65766173, "parameter_store compares other signatures");
            case 0x101101:
                return known_if(bits == 0x64616F6C, "parameter_store compares other signatures");
            case 0x101500:
                return known_if(bits % 10 == 0, "the clock of the model has milliseconds");
            case 0x101601: {
                const std::uint32_t producer = bits >> 16U;
                const bool is_other = producer >= 1 && producer <= 127 && producer != node;
                return known_if(bits == 0 || (is_other && (bits & 0xFFFFU) != 0),
                                "error_control compares other entries of 1016h");
            }
            case 0x140102:
                return known_if(bits <= 240 || bits >= 254, "pdo compares the reserved transmission types");
            case 0x1F9101:
                return known_if(bits != 0, "the clock of the model has milliseconds");
            default:
                return known_if(is_of_an_output(write), "the model has no such parameter");
        }
    }

    naive_ao4::Device model_{{}, {}};
};

[[maybe_unused]] const bool is_set = fuzz::set_beside_model(fuzz::run_beside_model<fuzz::CbxAo412Unit, Model>);

}  // namespace
