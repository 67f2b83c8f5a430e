// SPDX-License-Identifier: Apache-2.0
// Runs an AX130751 and its naive model side by side: both get the same writes, frames, inputs and time.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "properties/devices/ax130751/driven_device.hpp"
#include "properties/devices/ax130751/naive_comparison.hpp"

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
    /// Writes an entry that configures PDOs or heartbeats. Only the device gets this write, because the model has these
    /// settings built in.
    void set_up(int index, int sub, std::uint32_t value, int bytes) {
        expect(fmt::format("answer to {:04X}h:{}", index, sub), device_.write(index, sub, value, bytes), 0);
    }
    void rpdo(int number, const std::vector<int>& bytes) {
        note(fmt::format("RPDO{} of {} bytes", number, bytes.size()));
        device_.receive(0x100 + 0x100 * static_cast<unsigned>(number) + node, bytes);
        model_.receive(number, bytes);
    }
    /// Sends a heartbeat of node `producer`, one of the nodes 5 to 8, to device and model.
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

    /// Compares all parameters of device and model. Called after a run.
    void compare_parameters() {
        with_comparison([](const auto& comparison) { comparison.parameters(); });
    }

    bool differs() const { return !difference_.empty(); }
    /// Returns, as text, the steps of the run and the first difference between device and model.
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
    template <typename Use>
    void with_comparison(const Use& use) {
        const auto check = [this](bool holds, const char* what, unsigned index) {
            if (!holds && difference_.empty()) {
                difference_ = fmt::format("{} {:X}h differs\n{}", what, index, frames());
            }
        };
        use(naive_ax130751::Comparison<decltype(check)>{device_.device(), model_, check});
    }
    void compare() {
        with_comparison([this](const auto& comparison) {
            comparison.outputs();
            comparison.values();
            comparison.errors();
            comparison.frames(device_.said);
        });
        device_.said.clear();
        model_.said.clear();
    }
    std::string frames() const {
        return "frames " + list_of(device_.said) + "and, by the manual, " + list_of(model_.said);
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
