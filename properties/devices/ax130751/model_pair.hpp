// An AX130751 and its naive model, side by side: both get the same writes, frames, inputs and time.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "properties/devices/ax130751/naive_device.hpp"
#include "tests/devices/ax130751/ax130751_bench.hpp"

namespace canproof::test {

class ModelPair {
  public:
    ModelPair() {
        bench_.power_on_silently();
        model_.start_up();
    }

    void write(int index, int sub, int value) {
        const int bytes = model_.entries().at({index, sub}).bytes;
        note(fmt::format("{:04X}h:{} := {}", index, sub, value));
        const std::uint32_t answer = download(index, sub, static_cast<std::uint32_t>(value), bytes);
        const std::uint32_t expected = model_.write(index, sub, value);
        expect(fmt::format("answer to {:04X}h:{} := {}", index, sub, value), answer, expected);
    }
    /// Entries of PDOs and heartbeats that the model knows by itself.
    void set_up(int index, int sub, std::uint32_t value, int bytes) {
        expect(fmt::format("answer to {:04X}h:{}", index, sub), download(index, sub, value, bytes), 0);
    }
    void rpdo(int number, const std::vector<int>& bytes) {
        note(fmt::format("RPDO{} of {} bytes", number, bytes.size()));
        receive(0x100 + 0x100 * static_cast<unsigned>(number) + node, bytes);
        model_.receive(number, bytes);
    }
    void heartbeat() {
        note("heartbeat");
        receive(0x705, {5});
        model_.heartbeat();
    }
    void command(int specifier) {
        note(fmt::format("NMT {}", specifier));
        receive(0, {specifier, static_cast<int>(node)});
        model_.command(specifier);
    }
    void store() {
        note("store");
        expect("answer to 1010h", download(0x1010, 1, 0x65766173, 4), 0);
        model_.store();
    }
    void inputs(float supply, float temperature, float load_1, float load_2) {
        note(fmt::format("{} V, {} degC, {} and {} Ohm", supply, temperature, load_1, load_2));
        model_.inputs = {supply, temperature, {load_1, load_2}};
        bench_.inputs.supply = supply;
        bench_.inputs.cpu_temperature = temperature;
        bench_.inputs.load = {load_1, load_2};
        bench_.device->set_inputs(bench_.inputs, bench_.now);
        collect();
    }
    void pass(int ms) {
        note(fmt::format("{} ms", ms));
        const Instant end = bench_.now + milliseconds(static_cast<std::uint64_t>(ms));
        while (bench_.device->next_deadline() <= end) {
            bench_.now =
                std::max(bench_.now, bench_.device->next_deadline(), [](Instant a, Instant b) { return a.us < b.us; });
            bench_.device->advance(bench_.now);
            collect();
        }
        bench_.now = end;
        for (int i = 0; i < ms; ++i) {
            model_.pass();
        }
        compare();
    }

    bool differs() const { return !difference_.empty(); }
    /// What was done, and what then was not the same.
    std::string report() const { return story_ + difference_; }

    naive_ax130751::Device& model() { return model_; }
    ax130751::Device& device() { return *bench_.device; }

    static constexpr unsigned node = 127;

  private:
    struct Bench : Ax130751Bench {
        void power_on_silently() {
            queue = TransmitQueue{};
            device = std::make_unique<ax130751::Device>(memory, queue, factory);
            device->power_on(inputs, now);
        }
    };

    void note(const std::string& step) { story_ += step + "\n"; }
    template <typename Real, typename Expected>
    void expect(const std::string& what, const Real& is, const Expected& expected) {
        const auto a = static_cast<double>(is);
        const auto b = static_cast<double>(expected);
        if (difference_.empty() && (a < b || a > b)) {
            difference_ = fmt::format("{} is {}, but {} by the manual", what, a, b);
        }
    }
    void receive(unsigned id, const std::vector<int>& bytes) {
        Frame frame = data_frame(id, static_cast<std::uint8_t>(bytes.size()));
        std::transform(bytes.begin(), bytes.end(), frame.data.begin(),
                       [](int byte) { return static_cast<std::uint8_t>(byte); });
        bench_.device->receive(frame, bench_.now);
        collect();
    }
    /// Takes what the device sends; answers of the SDO server apart.
    void collect() {
        while (!bench_.queue.empty()) {
            const Frame frame = bench_.queue.pop();
            if (frame.id == 0x580 + node) {
                answer_ = frame;
            } else {
                said_.push_back(
                    {bench_.now.us / 1000, frame.id, {frame.data.begin(), frame.data.begin() + frame.length}});
            }
        }
    }
    std::uint32_t download(int index, int sub, std::uint32_t value, int bytes) {
        const auto byte = [](auto number, unsigned at) { return static_cast<int>(number >> (8U * at) & 0xFFU); };
        const auto address = static_cast<unsigned>(index);
        answer_ = Frame{};
        receive(0x600 + node,
                {0x23 + 4 * (4 - bytes), byte(address, 0), byte(address, 1), sub, byte(value, 0),
                 bytes > 1 ? byte(value, 1) : 0, bytes > 2 ? byte(value, 2) : 0, bytes > 3 ? byte(value, 3) : 0});
        if (answer_.data[0] == 0x60) {
            return 0;
        }
        std::uint32_t code = 0;
        for (std::size_t i = 8; i > 4; --i) {
            code = code << 8U | answer_.data.at(i - 1);
        }
        return answer_.data[0] == 0x80 ? code : ~std::uint32_t{0};
    }

    void compare() {
        compare_outputs();
        compare_values();
        compare_parameters();
        compare_errors();
        compare_frames();
    }
    void compare_outputs() {
        const auto& outputs = bench_.device->outputs();
        for (std::size_t n = 0; n < 2; ++n) {
            const naive_ax130751::Terminals& terminals = model_.terminals.at(n);
            const auto name = [n](const char* what) { return fmt::format("{} of output {}", what, n + 1); };
            expect(name("voltage"), outputs.out_voltage.at(n), static_cast<float>(terminals.volts));
            expect(name("current"), outputs.out_current.at(n), static_cast<float>(terminals.milliamperes));
            expect(name("duty cycle"), outputs.out_duty.at(n), static_cast<float>(terminals.duty));
            expect(name("frequency"), outputs.out_frequency.at(n), static_cast<float>(terminals.hertz));
            expect(name("level"), outputs.out_level.at(n), static_cast<float>(terminals.level));
            expect(name("state"), outputs.out_on.at(n), terminals.on);
        }
        expect("relay on NC", outputs.relay_nc, model_.relay_on_nc);
        expect("relay on NO", outputs.relay_no, !model_.relay_on_nc);
    }
    void expect_entry(int index, int sub, int expected, unsigned bytes) {
        const std::uint64_t raw =
            bench_.device->objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
        const std::uint64_t mask = (std::uint64_t{1} << (8U * bytes)) - 1U;
        expect(fmt::format("{:04X}h:{}", index, sub), raw & mask, static_cast<std::uint64_t>(expected) & mask);
    }
    void compare_values() {
        const naive_ax130751::Shown& shown = model_.shown;
        for (int n = 1; n <= 10; ++n) {
            expect_entry(naive_ax130751::table_index(n) + 8, 0, shown.tables.at(static_cast<std::size_t>(n - 1)).output,
                         2);
        }
        for (int n = 1; n <= 3; ++n) {
            const auto& logic = shown.logic.at(static_cast<std::size_t>(n - 1));
            expect_entry(0x3310, n, logic.selected, 1);
            expect_entry(0x3320, n, logic.output, 2);
        }
        for (int n = 1; n <= 4; ++n) {
            expect_entry(0x4030, n, shown.math.at(static_cast<std::size_t>(n - 1)), 2);
        }
        for (int n = 1; n <= 2; ++n) {
            expect_entry(0x7330, n, shown.target.at(static_cast<std::size_t>(n - 1)), 2);
            expect_entry(0x2370, n, shown.feedback.at(static_cast<std::size_t>(n - 1)), 2);
        }
        expect("state of the node", bench_.device->state() == NmtState::operational,
               model_.state == naive_ax130751::Nmt::operational);
    }
    void compare_parameters() {
        for (const auto& [address, entry] : model_.entries()) {
            expect_entry(address.first, address.second, *entry.value, static_cast<unsigned>(entry.bytes));
        }
    }
    void compare_errors() {
        expect_entry(0x1001, 0, model_.errors.reg(), 1);
        const auto& list = model_.errors.list();
        expect_entry(0x1003, 0, static_cast<int>(list.size()), 1);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::uint32_t entry = bench_.device->objects().read(0x1003, static_cast<std::uint8_t>(i + 1));
            expect(fmt::format("1003h:{}", i + 1), entry, list.at(i));
        }
    }
    /// The order of frames of one identifier counts.
    void compare_frames() {
        const auto by_identifier = [](const std::vector<naive_ax130751::Said>& said) {
            std::multimap<unsigned, naive_ax130751::Said> all;
            for (const auto& frame : said) {
                all.emplace(frame.id, frame);
            }
            return all;
        };
        if (difference_.empty() && by_identifier(said_) != by_identifier(model_.said)) {
            difference_ = "frames " + list_of(said_) + "are, by the manual, " + list_of(model_.said);
        }
        said_.clear();
        model_.said.clear();
    }
    static std::string list_of(const std::vector<naive_ax130751::Said>& said) {
        std::string text;
        for (const auto& frame : said) {
            text += fmt::format("{}:{:03X}#", frame.at, frame.id);
            for (const int byte : frame.data) {
                text += fmt::format("{:02X}", byte);
            }
            text += " ";
        }
        return text;
    }

    Bench bench_;
    naive_ax130751::Device model_{node};
    Frame answer_{};
    std::vector<naive_ax130751::Said> said_;
    std::string story_;
    std::string difference_;
};

}  // namespace canproof::test
