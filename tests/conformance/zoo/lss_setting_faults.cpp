// SPDX-License-Identifier: Apache-2.0
// Faults of LSS services that set and store node-ID and bit rate.
#include "tests/conformance/zoo/faults.hpp"
#include "tests/conformance/zoo/lss_frames.hpp"

namespace canproof::test::zoo {

namespace {

/// Makes the slave answer `command` with error code `other` instead of `error`.
Distortion tells_error(unsigned command, unsigned error, unsigned other) {
    return answers_lss_otherwise([=](WrongSlave&, const Frame& frame) {
        const bool is_it = frame.data[0] == command && frame.data[1] == error;
        return is_it ? with_byte(frame, 1, other) : frame;
    });
}

/// Makes the slave confirm a request of LSS configuration and ignore it.
Distortion forgets(unsigned command) {
    return serves_lss([command](WrongSlave& slave, const Frame& frame) {
        const bool known = command != 0x11 || (frame.data[1] >= 1 && frame.data[1] <= 127) || frame.data[1] == 255;
        if (frame.data[0] != command || !is_configuring(slave) || !known) {
            return false;
        }
        slave.say(lss_answer(command, 0));
        return true;
    });
}

bool ignore_activation(WrongSlave&, const Frame& frame) {
    return frame.data[0] == 0x15;
}

/// Makes the slave store each node-ID that LSS sets, although the master sent no store request.
Distortion stores_unasked() {
    return serves_lss([](WrongSlave& slave, const Frame& frame) {
        slave.pass(frame);
        if (frame.data[0] == 0x11 && is_configuring(slave)) {
            slave.notes[0] = 1;
            slave.pass(lss_request(0x17, 0));
        }
        return true;
    });
}

/// Like stores_unasked(), but the slave sends no answer to the store request, because no master sent one.
Distortion stores_silently() {
    Distortion both = stores_unasked();
    const auto say = [inner = both.say](WrongSlave& slave, const Frame& frame) {
        const bool unasked = is_data(frame, lss_answers) && frame.data[0] == 0x17 && slave.notes[0] != 0;
        if (unasked) {
            slave.notes[0] = 0;
        } else {
            inner(slave, frame);
        }
    };
    both.say = say;
    return both;
}

}  // namespace

Faults lss_setting_faults() {
    const std::string configure = "7E5#0401000000000000 ";
    const std::string wait = "7E5#0400000000000000 ";
    const std::string node_6 = "7E5#1106000000000000 ";
    const std::string store = "7E5#1700000000000000 ";
    return {
        {"lss-node-id-0", "lss", "confirms a node-ID that does not exist", configure + "7E5#1100000000000000",
         "7E4#1101000000000000", "7E4#1100000000000000", tells_error(0x11, 1, 0)},
        {"lss-node-id-refused", "lss", "refuses a node-ID", configure + node_6, "7E4#1100000000000000",
         "7E4#1101000000000000", tells_error(0x11, 0, 1)},
        {"lss-node-id-lost", "lss", "confirms a node-ID and forgets it", configure + node_6 + "000#8205", "706#00",
         "705#00", forgets(0x11)},
        {"lss-node-id-stored", "lss", "stores a node-ID that nobody asked it to store", configure + node_6 + "000#8105",
         "705#00", "706#00", stores_silently()},
        {"lss-bit-timing-reserved", "lss", "confirms a reserved index of the bit timing table",
         configure + "7E5#1300050000000000", "7E4#1301000000000000", "7E4#1300000000000000", tells_error(0x13, 1, 0)},
        {"lss-store-lost", "lss", "confirms that it stores and does not", configure + node_6 + store + "000#8105",
         "706#00", "705#00", forgets(0x17)},
        {"lss-activation-ignored", "lss", "answers while a bit rate is being switched",
         configure + "7E5#1564000000000000 605#4001100000000000", "", "585#4F01100000000000",
         serves_lss(ignore_activation)},
    };
}

}  // namespace canproof::test::zoo
