// SPDX-License-Identifier: Apache-2.0
// Faults of LSS states, selection and identification.
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/lss_frames.hpp"

namespace canproof::test::zoo {

namespace {

/// Makes the slave serve requests in LSS waiting that are allowed only in LSS configuration.
bool serve_in_waiting(WrongSlave& slave, const Frame& frame) {
    const unsigned command = frame.data[0];
    const bool asks = command >= 0x5A && command <= 0x5E;
    const bool sets = command == 0x11 || command == 0x13 || command == 0x17;
    if (is_configuring(slave) || (!asks && !sets)) {
        return false;
    }
    slave.pass(lss_mode(true));
    slave.pass(frame);
    slave.pass(lss_mode(false));
    return true;
}

/// Makes the slave accept any number in the frame `command` of the LSS service switch state selective.
Distortion selects_any(unsigned command) {
    return serves_lss([command](WrongSlave& slave, const Frame& frame) {
        if (frame.data[0] != command) {
            return false;
        }
        slave.pass(with_own_number(slave, frame, command - 0x40U));
        return true;
    });
}

/// Makes the slave answer the LSS service identify remote slave whatever ranges the request has.
bool identify_always(WrongSlave& slave, const Frame& frame) {
    constexpr unsigned first = 0x46;
    constexpr unsigned numbers[]{0, 1, 2, 2, 3, 3};
    const unsigned step = frame.data[0] - first;
    if (frame.data[0] < first || step > 5) {
        return false;
    }
    slave.pass(with_own_number(slave, frame, numbers[step]));
    return true;
}

/// Makes the slave exclude the upper bounds of the ranges in identify remote slave; a correct slave includes them.
bool exclude_upper_end(WrongSlave& slave, const Frame& frame) {
    if (frame.data[0] != 0x49 && frame.data[0] != 0x4B) {
        return false;
    }
    Frame less = frame;
    set_field_le<1, 4>(less.data, field_le<1, 4>(frame.data) - 1U);
    slave.pass(less);
    return true;
}

bool answer_switch(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (frame.data[0] == 0x04) {
        slave.say(with_id(frame, lss_answers));
    }
    return true;
}

bool ignore_leaving(WrongSlave&, const Frame& frame) {
    return frame.data[0] == 0x04 && frame.data[1] == 0;
}

/// Makes the slave answer LSS Fastscan although it has a node-ID.
bool scan_configured(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (frame.data[0] == 0x51 && frame.data[5] == 0x80 && slave.node_id() <= 127) {
        slave.say(lss_answer(0x4F, 0));
    }
    return true;
}

bool answer_non_configured(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (frame.data[0] == 0x4C && slave.node_id() <= 127) {
        slave.say(lss_answer(0x50, 0));
    }
    return true;
}

/// Makes the slave enter LSS configuration after the third number of Fastscan instead of the fourth.
bool finish_scan_early(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    const bool third = frame.data[0] == 0x51 && frame.data[5] == 0 && frame.data[6] == 2 && frame.data[7] == 3;
    if (third && slave.node_id() > 127) {
        slave.pass(lss_mode(true));
    }
    return true;
}

/// Makes the slave accept every number in a Fastscan request as its own.
bool match_any(WrongSlave& slave, const Frame& frame) {
    if (frame.data[0] != 0x51 || frame.data[6] > 3) {
        return false;
    }
    slave.pass(with_own_number(slave, frame, frame.data[6]));
    return true;
}

Frame with_vendor_for_product(WrongSlave& slave, const Frame& frame) {
    return frame.data[0] == 0x5B ? with_own_number(slave, frame, 0) : frame;
}
Frame with_next_node_id(WrongSlave&, const Frame& frame) {
    return frame.data[0] == 0x5E ? with_byte(frame, 1, frame.data[1] + 1U) : frame;
}

}  // namespace

Faults lss_faults() {
    const std::string configure = "7E5#0401000000000000 ";
    const std::string wait = "7E5#0400000000000000 ";
    const std::string inquire = "7E5#5E00000000000000 ";
    const std::string node_5 = "7E4#5E05000000000000";
    const std::string found = "7E4#4F00000000000000";
    // These frames remove the node-ID of the slave.
    const std::string forget = configure + "7E5#11FF000000000000 " + wait + "000#8205 ";
    return {
        {"lss-waiting-answered", "lss", "serves requests of LSS configuration in LSS waiting", inquire, "", node_5,
         serves_lss(serve_in_waiting)},
        {"lss-select-any-serial", "lss", "is selected with a wrong serial number",
         "7E5#405F000000000000 7E5#41010302AA000000 7E5#4202000100000000 7E5#4322112620000000", "",
         "7E4#4400000000000000", selects_any(0x43)},
        {"lss-select-any-vendor", "lss", "is selected with a wrong vendor-ID",
         "7E5#4060000000000000 7E5#41010302AA000000 7E5#4202000100000000 7E5#4321112620000000", "",
         "7E4#4400000000000000", selects_any(0x40)},
        {"lss-switch-answered", "lss", "answers switch state global", configure, "", "7E4#0401000000000000",
         serves_lss(answer_switch)},
        {"lss-waiting-ignored", "lss", "does not leave LSS configuration", configure + wait + inquire, "", node_5,
         serves_lss(ignore_leaving)},
        {"lss-inquire-product", "lss", "gives its vendor-ID for its product code", configure + "7E5#5B00000000000000",
         "7E4#5B010302AA000000", "7E4#5B5F000000000000", answers_lss_otherwise(with_vendor_for_product)},
        {"lss-inquire-node-id", "lss", "gives a node-ID that is one too high", configure + inquire, node_5,
         "7E4#5E06000000000000", answers_lss_otherwise(with_next_node_id)},
        {"lss-identify-any", "lss", "identifies itself whatever the ranges are",
         "7E5#4660000000000000 7E5#47010302AA000000 7E5#4802000100000000 7E5#4902000100000000 "
         "7E5#4A21112620000000 7E5#4B21112620000000",
         "", found, serves_lss(identify_always)},
        {"lss-identify-edge", "lss", "does not identify itself at the upper end of a range",
         "7E5#465F000000000000 7E5#47010302AA000000 7E5#4802000100000000 7E5#4902000100000000 "
         "7E5#4A21112620000000 7E5#4B21112620000000",
         found, "", serves_lss(exclude_upper_end)},
        {"lss-fastscan-configured", "lss", "answers Fastscan although it has a node-ID", "7E5#5100000000800000", "",
         found, serves_lss(scan_configured)},
        {"lss-non-configured", "lss", "identifies itself as a slave without a node-ID although it has one",
         "7E5#4C00000000000000", "", "7E4#5000000000000000", serves_lss(answer_non_configured)},
        {"lss-fastscan-early", "lss", "goes to LSS configuration before the fourth number of Fastscan",
         forget + "7E5#5100000000800000 7E5#515F000000000001 7E5#51010302AA000102 7E5#5102000100000203 " + inquire, "",
         "7E4#5EFF000000000000", serves_lss(finish_scan_early)},
        {"lss-fastscan-any", "lss", "finds every number of Fastscan its own",
         forget + "7E5#5100000000800000 7E5#5160000000000001", "", found, serves_lss(match_any)},
    };
}

}  // namespace canproof::test::zoo
