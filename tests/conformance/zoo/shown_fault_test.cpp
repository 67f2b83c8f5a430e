// SPDX-License-Identifier: Apache-2.0
// Checks that each deliberate fault has exactly the effect that its entry in the table of faults lists. The same
// exchange is run with the correct slave and with the slave that has the fault. The results must differ only by the
// listed frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "host/sim/bus/candump.hpp"
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/wrong_slave.hpp"

namespace canproof::test::zoo {

namespace {

using Texts = std::vector<std::string>;

Texts words(const std::string& text) {
    std::istringstream in{text};
    return {std::istream_iterator<std::string>{in}, std::istream_iterator<std::string>{}};
}

/// Runs an exchange with one slave, in virtual time. The frames that the slave sends are recorded as text, with the
/// milliseconds since the start.
class Talk {
  public:
    explicit Talk(const Distortion& distortion) : slave_{distortion} {
        slave_.power_on(Instant{});
        take_frames();
        said_.clear();
    }

    Texts hold(const std::string& talk) {
        for (const std::string& step : words(talk)) {
            if (step.front() == '+') {
                wait(milliseconds(std::stoul(step.substr(1))));
            } else {
                slave_.receive(host::parse_frame(step, "talk"), now_);
                wait({});
            }
        }
        std::sort(said_.begin(), said_.end());
        return said_;
    }

  private:
    void wait(Duration time) {
        const Instant end = now_ + time;
        take_frames();
        while (slave_.next_deadline() <= end) {
            now_ = std::max(now_, slave_.next_deadline(), [](Instant a, Instant b) { return a < b; });
            slave_.advance(now_);
            take_frames();
        }
        now_ = end;
    }
    void take_frames() {
        while (!slave_.queue().empty()) {
            const std::string time = now_.us == 0 ? "" : std::to_string(now_.us / 1000) + ":";
            said_.push_back(time + host::format_frame(slave_.queue().pop()));
        }
    }

    WrongSlave slave_;
    Instant now_{};
    Texts said_;
};

Texts only_in_first(const Texts& first, const Texts& second) {
    Texts rest;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(rest));
    return rest;
}

Texts sorted(const std::string& text) {
    Texts all = words(text);
    std::sort(all.begin(), all.end());
    return all;
}

class ShownFault : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST_P(ShownFault, FaultySlaveDiffersFromTheCorrectSlaveInTheListedFrames) {
    const Fault& fault = all_faults()[GetParam()];
    const Texts right = Talk{{}}.hold(fault.talk);
    const Texts wrong = Talk{fault.distortion}.hold(fault.talk);
    EXPECT_EQ(only_in_first(right, wrong), sorted(fault.right)) << fault.id << ": the correct slave alone";
    EXPECT_EQ(only_in_first(wrong, right), sorted(fault.wrong)) << fault.id << ": the wrong slave alone";
}

INSTANTIATE_TEST_SUITE_P(Zoo, ShownFault, testing::Range<std::size_t>(0, all_faults().size()), [](const auto& one) {
    std::string name = all_faults()[one.param].id;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(FaultySlaves, EverySlaveFaultHasAUniqueIdADescriptionAndAListedDifference) {
    std::set<std::string> ids;
    for (const Fault& fault : all_faults()) {
        EXPECT_TRUE(ids.insert(fault.id).second) << fault.id;
        EXPECT_FALSE(fault.right.empty() && fault.wrong.empty()) << fault.id;
        EXPECT_FALSE(fault.what.empty()) << fault.id;
    }
    EXPECT_GE(ids.size(), 60U);
}

}  // namespace canproof::test::zoo
