// SPDX-License-Identifier: Apache-2.0
// Runs an AX130751 and its naive model side by side: both get the same writes, frames, inputs and time.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "properties/devices/ax130751/driven_device.hpp"
#include "properties/devices/ax130751/naive_device.hpp"

namespace canproof::test {

class ModelPair {
  public:
    ModelPair() { model_.start_up(); }

    void write(int index, int sub, int value) {
        const int bytes = model_.entries().at({index, sub}).bytes;
        note(fmt::format("{:04X}h:{} := {}", index, sub, value));
        const std::uint32_t answer = device_.write(index, sub, static_cast<std::uint32_t>(value), bytes);
        const std::uint32_t expected = model_.write(index, sub, value);
        expect(fmt::format("answer to {:04X}h:{} := {}", index, sub, value), answer, expected);
    }
    /// Writes an entry of PDOs or heartbeats to the device only: the model has these settings built in.
    void set_up(int index, int sub, std::uint32_t value, int bytes) {
        expect(fmt::format("answer to {:04X}h:{}", index, sub), device_.write(index, sub, value, bytes), 0);
    }
    void rpdo(int number, const std::vector<int>& bytes) {
        note(fmt::format("RPDO{} of {} bytes", number, bytes.size()));
        device_.receive(0x100 + 0x100 * static_cast<unsigned>(number) + node, bytes);
        model_.receive(number, bytes);
    }
    /// Sends a heartbeat of node 5 to 8.
    void heartbeat(unsigned producer) {
        note(fmt::format("heartbeat of {}", producer));
        device_.receive(0x700 + producer, {5});
        model_.heartbeat(producer);
    }
    void command(int specifier) {
        note(fmt::format("NMT {}", specifier));
        device_.receive(0, {specifier, static_cast<int>(node)});
        model_.command(specifier);
    }
    void store() {
        note("store");
        expect("answer to 1010h", device_.write(0x1010, 1, 0x65766173, 4), 0);
        model_.store();
    }
    void inputs(float supply, float temperature, float load_1, float load_2) {
        note(fmt::format("{} V, {} degC, {} and {} Ohm", supply, temperature, load_1, load_2));
        model_.inputs = {supply, temperature, {load_1, load_2}};
        device_.inputs(model_.inputs);
    }
    void pass(int ms) {
        note(fmt::format("{} ms", ms));
        device_.pass(ms);
        for (int i = 0; i < ms; ++i) {
            model_.pass();
        }
        compare();
    }

    /// Compares all parameters after a run.
    void compare_parameters() {
        for (const auto& [address, entry] : model_.entries()) {
            expect_entry(address.first, address.second, *entry.value, static_cast<unsigned>(entry.bytes));
        }
    }

    bool differs() const { return !difference_.empty(); }
    /// Returns the steps of the run and the first difference.
    std::string report() const { return story_ + difference_; }

    naive_ax130751::Device& model() { return model_; }

    static constexpr unsigned node = DrivenDevice::node;

  private:
    void note(const std::string& step) { story_ += step + "\n"; }
    template <typename What, typename Real, typename Expected>
    void expect(const What& what, const Real& is, const Expected& expected) {
        const auto a = static_cast<double>(is);
        const auto b = static_cast<double>(expected);
        if (difference_.empty() && (a < b || a > b)) {
            difference_ = fmt::format("{} is {}, but {} by the manual", what, a, b);
        }
    }
    void compare() {
        compare_outputs();
        compare_values();
        compare_errors();
        compare_frames();
    }
    void compare_outputs() {
        const auto& outputs = device_.device().outputs();
        for (std::size_t n = 0; n < 2; ++n) {
            const naive_ax130751::Terminals& terminals = model_.terminals.at(n);
            expect("voltage", outputs.out_voltage.at(n), static_cast<float>(terminals.volts));
            expect("current", outputs.out_current.at(n), static_cast<float>(terminals.milliamperes));
            expect("duty cycle", outputs.out_duty.at(n), static_cast<float>(terminals.duty));
            expect("frequency", outputs.out_frequency.at(n), static_cast<float>(terminals.hertz));
            expect("level", outputs.out_level.at(n), static_cast<float>(terminals.level));
            expect("state", outputs.out_on.at(n), terminals.on);
        }
        expect("relay on NC", outputs.relay_nc, model_.relay_on_nc);
        expect("relay on NO", outputs.relay_no, !model_.relay_on_nc);
    }
    void expect_entry(int index, int sub, int expected, unsigned bytes) {
        const std::uint64_t raw = device_.read(index, sub);
        const std::uint64_t mask = (std::uint64_t{1} << (8U * bytes)) - 1U;
        if ((raw & mask) != (static_cast<std::uint64_t>(expected) & mask)) {
            expect(fmt::format("{:04X}h:{}", index, sub), raw & mask, static_cast<std::uint64_t>(expected) & mask);
        }
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
        expect("state of the node", device_.device().state() == NmtState::operational,
               model_.state == naive_ax130751::Nmt::operational);
    }
    void compare_errors() {
        expect_entry(0x1001, 0, model_.errors.reg(), 1);
        const auto& list = model_.errors.list();
        expect_entry(0x1003, 0, static_cast<int>(list.size()), 1);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::uint32_t entry = static_cast<std::uint32_t>(device_.read(0x1003, static_cast<int>(i + 1)));
            expect(fmt::format("1003h:{}", i + 1), entry, list.at(i));
        }
    }
    /// Compares the frames; the order of frames of one identifier counts.
    void compare_frames() {
        const auto by_identifier = [](const std::vector<naive_ax130751::Said>& said) {
            std::multimap<unsigned, naive_ax130751::Said> all;
            for (const auto& frame : said) {
                all.emplace(frame.id, frame);
            }
            return all;
        };
        if (difference_.empty() && by_identifier(device_.said) != by_identifier(model_.said)) {
            difference_ = "frames " + list_of(device_.said) + "are, by the manual, " + list_of(model_.said);
        }
        device_.said.clear();
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

    DrivenDevice device_;
    naive_ax130751::Device model_{node};
    std::string story_;
    std::string difference_;
};

}  // namespace canproof::test
