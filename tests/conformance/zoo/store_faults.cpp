// SPDX-License-Identifier: Apache-2.0
// Faults of 1010h (store parameters) and 1011h (restore default parameters).
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

constexpr std::uint16_t store = 0x1010;
constexpr std::uint16_t restore = 0x1011;
constexpr std::uint32_t save_signature = 0x65766173;
constexpr std::uint32_t load_signature = 0x64616F6C;

bool is_signature(const WrongSlave& slave, const Frame& frame, std::uint16_t index) {
    return is_sdo_request(slave, frame) && is_expedited_download(frame) && index_of(frame) == index &&
           sub_of(frame) != 0;
}

Distortion takes_any_signature(std::uint16_t index, std::uint32_t right) {
    return takes_requests_as([=](WrongSlave& slave, const Frame& frame) {
        return is_signature(slave, frame, index) ? with_value(frame, right) : frame;
    });
}

/// Makes the slave confirm a store or restore request with this signature and do nothing.
Distortion does_nothing(std::uint16_t index, std::uint32_t signature) {
    return hears([=](WrongSlave& slave, const Frame& frame) {
        if (is_signature(slave, frame, index) && value_of(frame) == signature) {
            slave.say(confirmation(slave.node_id(), frame));
        } else {
            slave.pass(frame);
        }
    });
}

void load_at_once(WrongSlave& slave, const Frame& frame) {
    slave.pass(frame);
    if (is_signature(slave, frame, restore) && value_of(frame) == load_signature) {
        for (const ParameterGroup group :
             {ParameterGroup::communication, ParameterGroup::application, ParameterGroup::manufacturer}) {
            slave.dictionary().load_defaults(group, slave.node_id());
        }
    }
}

/// Makes the slave execute the request for sub-index `asked` of 1010h or 1011h as if it was for `done`. The answer
/// still names `asked`.
Distortion does_for(std::uint16_t index, std::uint8_t asked, std::uint8_t done) {
    const auto hear = [=](WrongSlave& slave, const Frame& frame) {
        const bool changes = is_signature(slave, frame, index) && sub_of(frame) == asked;
        slave.notes[0] = changes ? 1 : 0;
        slave.pass(changes ? with_byte(frame, 3, done) : frame);
    };
    const auto say = [=](WrongSlave& slave, const Frame& frame) {
        const bool changed = is_sdo_answer(slave, frame) && slave.notes[0] != 0;
        slave.say(changed ? with_byte(frame, 3, asked) : frame);
    };
    return hears_and_says(hear, say);
}

Distortion reads_0(std::uint16_t index) {
    return answers_otherwise([index](WrongSlave&, const Frame& frame) {
        const bool reads = is_expedited_answer(frame) && index_of(frame) == index && sub_of(frame) != 0;
        return reads ? with_value(frame, 0) : frame;
    });
}

}  // namespace

Faults store_faults() {
    const std::string write_8 = "605#2F01220008000000 ";  // 2201h = 8, which differs from its default 2
    const std::string save = "605#2310100173617665 ";
    const std::string load = "605#231110016C6F6164 ";
    const std::string reset = "000#8105 ";
    const std::string read = "605#4001220000000000";
    const std::string is_2 = "585#4F01220002000000";
    const std::string is_8 = "585#4F01220008000000";
    return {
        {"store-any-signature", "store", "stores with a wrong signature", "605#231010016E6F7277",
         "585#8010100120000008", "585#6010100100000000", takes_any_signature(store, save_signature)},
        {"restore-any-signature", "store", "restores with a wrong signature", "605#231110016E6F7277",
         "585#8011100120000008", "585#6011100100000000", takes_any_signature(restore, load_signature)},
        {"store-lost", "store", "confirms that it stores and does not", write_8 + save + reset + read, is_8, is_2,
         does_nothing(store, save_signature)},
        {"restore-lost", "store", "confirms that it restores and does not", write_8 + save + load + reset + read, is_2,
         is_8, does_nothing(restore, load_signature)},
        {"restore-at-once", "store", "restores at once, not at the next reset", write_8 + load + read, is_8, is_2,
         hears(load_at_once)},
        {"store-code", "store", "refuses a wrong signature with 06010000h", "605#231010016E6F7277",
         "585#8010100120000008", "585#8010100100000106", aborts_with(0x08000020, 0x06010000)},
        {"store-capability", "store", "reads 0 from 1010h although it stores", "605#4010100100000000",
         "585#4310100101000000", "585#4310100100000000", reads_0(store)},
        {"restore-capability", "store", "reads 0 from 1011h although it restores", "605#4011100100000000",
         "585#4311100101000000", "585#4311100100000000", reads_0(restore)},
        {"store-too-much", "store", "stores all parameters when it shall store the communication parameters",
         write_8 + "605#2310100273617665 " + reset + read, is_2, is_8, does_for(store, 2, 1)},
        {"store-too-little", "store", "stores the communication parameters when it shall store all",
         write_8 + save + reset + read, is_8, is_2, does_for(store, 1, 2)},
        {"restore-too-much", "store", "restores all parameters when it shall restore the communication parameters",
         write_8 + save + "605#231110026C6F6164 " + reset + read, is_8, is_2, does_for(restore, 2, 1)},
        {"restore-too-little", "store", "restores the communication parameters when it shall restore all",
         write_8 + save + load + reset + read, is_2, is_8, does_for(restore, 1, 2)},
    };
}

}  // namespace canproof::test::zoo
