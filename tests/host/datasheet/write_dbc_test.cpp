// SPDX-License-Identifier: Apache-2.0
// Tests the DBC file with the frames of a device. A small reader in this test reads it back.
#include "host/datasheet/write_dbc.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "host/datasheet/dbc_text.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/selection/built_in.hpp"
#include "tests/host/datasheet/check/good_sheet.hpp"

namespace canproof::host::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Signal {
    std::string multiplex;  ///< empty, "M" for the multiplexer, or "m" and a value of it
    unsigned start{0};
    unsigned length{0};
    bool is_signed{false};
    std::string limits;
    std::string unit;
    std::string receiver;
    int real{0};  ///< 1 single, 2 double
    std::map<unsigned, std::string> words;
};

struct Message {
    std::string name;
    unsigned length{0};
    std::string sender;
    std::map<std::string, Signal> signals;
};

struct Database {
    std::vector<std::string> nodes;
    std::map<std::uint32_t, Message> messages;
    std::string faults;  ///< faults in the format of the file
};

/// Parses a DBC file line by line and checks its format.
class DbcReader {
  public:
    Database read(const std::string& text) {
        std::istringstream in{text};
        for (std::string line; std::getline(in, line);) {
            read_line(line);
        }
        for (const auto& [id, message] : data_.messages) {
            check_places(message);
        }
        return data_;
    }

  private:
    void fault(const std::string& what) { data_.faults += what + "\n"; }

    void read_line(const std::string& line) {
        static const std::regex node_list{R"re(BU_: (.*))re"};
        static const std::regex message{R"re(BO_ (\d+) (\w+): (\d) (\w+))re"};
        static const std::regex signal{
            R"re( SG_ (\w+)( M| m\d+)? : (\d+)\|(\d+)@1([+-]) \(1,0\) \[([^\]]*)\] "([^"]*)" (\w+))re"};
        static const std::regex real{R"re(SIG_VALTYPE_ (\d+) (\w+) : ([12]);)re"};
        static const std::regex comment{R"re(CM_(?: BO_ (\d+)| SG_ (\d+) (\w+))? "[^"]*";)re"};
        static const std::regex other{R"re(|VERSION ""|NS_ :|BS_:)re"};
        std::smatch found;
        if (std::regex_match(line, found, node_list)) {
            std::istringstream nodes{found[1].str()};
            for (std::string node; nodes >> node;) {
                data_.nodes.push_back(node);
            }
        } else if (std::regex_match(line, found, message)) {
            last_ = static_cast<std::uint32_t>(std::stoul(found[1]));
            const auto [place, is_new] = data_.messages.emplace(
                last_, Message{found[2], static_cast<unsigned>(std::stoul(found[3])), found[4], {}});
            if (!is_new || !messages_.insert(found[2]).second) {
                fault("twice: " + line);
            }
            check_name(found[2]);
            check_node(found[4]);
        } else if (std::regex_match(line, found, signal)) {
            Signal one;
            one.multiplex = found[2].length() == 0 ? "" : found[2].str().substr(1);
            one.start = static_cast<unsigned>(std::stoul(found[3]));
            one.length = static_cast<unsigned>(std::stoul(found[4]));
            one.is_signed = found[5] == "-";
            one.limits = found[6];
            one.unit = found[7];
            one.receiver = found[8];
            if (!data_.messages[last_].signals.emplace(found[1], one).second) {
                fault("twice: " + line);
            }
            check_name(found[1]);
            check_node(found[8]);
        } else if (line.rfind("VAL_ ", 0) == 0) {
            read_words(line);
        } else if (std::regex_match(line, found, real)) {
            signal_of(found[1], found[2]).real = std::stoi(found[3]);
        } else if (std::regex_match(line, found, comment)) {
            if (found[2].matched) {
                signal_of(found[2], found[3]);
            }
        } else if (!std::regex_match(line, other)) {
            fault("no line of a DBC: " + line);
        }
    }

    void check_name(const std::string& name) {
        static const std::regex identifier{"[A-Za-z_][A-Za-z0-9_]{0,31}"};
        if (!std::regex_match(name, identifier)) {
            fault("no identifier: " + name);
        }
    }

    void check_node(const std::string& name) {
        if (std::count(data_.nodes.begin(), data_.nodes.end(), name) != 1) {
            fault("no node: " + name);
        }
    }

    Signal& signal_of(const std::string& id, const std::string& name) {
        Message& message = data_.messages[static_cast<std::uint32_t>(std::stoul(id))];
        if (message.signals.count(name) == 0) {
            fault("no such signal: " + name);
        }
        return message.signals[name];
    }

    /// Reads the names of values, with any number of them: VAL_ 5 Name 1 "one" 2 "two" ;
    void read_words(const std::string& line) {
        std::istringstream in{line.substr(5)};
        std::string id;
        std::string name;
        in >> id >> name;
        Signal& signal = signal_of(id, name);
        unsigned value = 0;
        while (in >> value) {
            in >> std::ws;
            const bool opens = in.get() == '"';
            std::string word;
            if (!opens || !std::getline(in, word, '"')) {
                fault("no word: " + line.substr(0, 60));
                return;
            }
            signal.words[value] = word;
        }
        in.clear();
        std::string end;
        if (!(in >> end) || end != ";" || signal.words.empty()) {
            fault("no end: " + line.substr(0, 60));
        }
    }

    /// Checks that signals are within the frame and share no bits unless the multiplexer selects one of them.
    void check_places(const Message& message) {
        std::map<std::string, std::set<unsigned>> used;  // for each multiplexer value, the bits that are used
        for (const auto& [name, signal] : message.signals) {
            const bool switched = signal.multiplex.size() > 1;
            for (unsigned bit = signal.start; bit < signal.start + signal.length; ++bit) {
                const bool fits = used[switched ? signal.multiplex : ""].insert(bit).second;
                if (!fits || bit >= message.length * 8U) {
                    fault("place of " + message.name + "." + name);
                }
            }
        }
        for (const auto& [value, bits] : used) {
            for (const unsigned bit : bits) {
                if (!value.empty() && used[""].count(bit) != 0) {
                    fault("switched signal over another in " + message.name);
                }
            }
        }
    }

    Database data_;
    std::set<std::string> messages_;
    std::uint32_t last_{0};
};

Database database_of(const std::string& sheet, unsigned node) {
    const EdsResult read = read_eds(sheet, "box.eds");
    EXPECT_TRUE(read.faults.empty());
    Database data = DbcReader{}.read(write_dbc(read.part, node));
    EXPECT_EQ(data.faults, "");
    return data;
}

std::string place(const Signal& signal) {
    return fmt::format("{}|{}{}", signal.start, signal.length, signal.is_signed ? '-' : '+');
}

std::vector<std::string> places(const Message& message) {
    std::vector<std::string> all;
    for (const auto& [name, signal] : message.signals) {
        all.push_back(name + " " + place(signal));
    }
    return all;
}

std::set<std::uint32_t> ids(const Database& data) {
    std::set<std::uint32_t> all;
    for (const auto& [id, message] : data.messages) {
        all.insert(id);
    }
    return all;
}

}  // namespace

TEST(WriteDbc, EachServiceHasItsIdentifierOfCia301) {
    const Database data = database_of(good_sheet(), 5);
    EXPECT_THAT(data.nodes, ElementsAre("Host", "box"));
    // Node 5: NMT, SYNC, EMCY 80h + 5, TPDO 180h + 5, RPDOs 200h + 5 and 300h + 5, SDO 580h + 5 and 600h + 5,
    // heartbeat.
    EXPECT_EQ(ids(data), (std::set<std::uint32_t>{0x000, 0x080, 0x085, 0x185, 0x205, 0x305, 0x585, 0x605, 0x705}));
    EXPECT_EQ(data.messages.at(0x185).name, "box_TPDO1");
    EXPECT_EQ(data.messages.at(0x185).sender, "box");
    EXPECT_EQ(data.messages.at(0x305).name, "box_RPDO2");
    EXPECT_EQ(data.messages.at(0x305).sender, "Host");
    EXPECT_EQ(data.messages.at(0x305).signals.at("Outputs_Entry_2").receiver, "box");
}

TEST(WriteDbc, PdoHasItsMappedObjectsAndGaps) {
    const Database data = database_of(good_sheet(), 5);
    EXPECT_THAT(places(data.messages.at(0x185)), ElementsAre("Inputs_Entry_1 0|8+", "Inputs_Entry_2 8|8+"));
    EXPECT_EQ(data.messages.at(0x185).length, 2U);
    // the PDO has 8 bits of 6200h:01, then 8 bits of the data type UNSIGNED8
    EXPECT_THAT(places(data.messages.at(0x205)), ElementsAre("Outputs_Entry_1 0|8+"));
    EXPECT_EQ(data.messages.at(0x205).length, 2U);
}

TEST(WriteDbc, PdoKeepsBitsSignsLimitsAndReals) {
    const Database data = database_of(
        patched_sheet("[1A00] SubNumber=4 | [1A00sub0] DefaultValue=3 | [1A00sub1] DefaultValue=0x20040001 | "
                      "[1A00sub2] DefaultValue=0x20000010 | [1A00sub3] ParameterName=Third | "
                      "[1A00sub3] DataType=0x0007 | [1A00sub3] AccessType=rw | [1A00sub3] DefaultValue=0x20030020")
            .text,
        127);
    const Message& pdo = data.messages.at(0x180 + 127);
    EXPECT_THAT(places(pdo), ElementsAre("Gain 17|32-", "Switch 0|1+", "Trim 1|16-"));
    EXPECT_EQ(pdo.length, 7U);  // 1 + 16 + 32 = 49 bits
    EXPECT_EQ(pdo.signals.at("Gain").real, 1);
    EXPECT_EQ(pdo.signals.at("Trim").real, 0);
    EXPECT_EQ(pdo.signals.at("Trim").limits, "-100|100");
    EXPECT_EQ(pdo.signals.at("Gain").limits, "0|10.5");
    EXPECT_EQ(pdo.signals.at("Switch").limits, "0|0");
}

TEST(WriteDbc, SdoIsMultiplexedByIndexAndSubIndex) {
    const Database data = database_of(good_sheet(), 5);
    const Message& request = data.messages.at(0x605);
    const Message& response = data.messages.at(0x585);
    EXPECT_EQ(request.signals.at("Object").multiplex, "M");
    EXPECT_EQ(place(request.signals.at("Object")), "8|24+");
    // 2003h:00 is read and written; its multiplexer is 2003h = 8195
    for (const Message* message : {&request, &response}) {
        const Signal& gain = message->signals.at("x2003_00_Gain");
        EXPECT_EQ(gain.multiplex, "m8195");
        EXPECT_EQ(place(gain), "32|32-");
        EXPECT_EQ(gain.real, 1);
    }
    // 1018h:04 (identity object) is read-only; its multiplexer is 4 x 65536 + 4120
    EXPECT_EQ(response.signals.at("x1018_04_Identity_Entry_4").multiplex, "m266264");
    EXPECT_EQ(request.signals.count("x1018_04_Identity_Entry_4"), 0U);
    // 6200h:02 is write-only; its multiplexer is 2 x 65536 + 25088
    EXPECT_EQ(request.signals.at("x6200_02_Outputs_Entry_2").multiplex, "m156160");
    EXPECT_EQ(response.signals.count("x6200_02_Outputs_Entry_2"), 0U);
    EXPECT_EQ(request.signals.at("Object").words.at(156160), "6200h:02");
    EXPECT_EQ(request.signals.at("Command").words.at(0x2B), "download 2 bytes");
    EXPECT_EQ(response.signals.at("Command").words.at(0x4B), "upload 2 bytes");
    // Strings and DOMAINs are transferred in segments.
    EXPECT_EQ(response.signals.count("x2001_00_Name"), 0U);
}

TEST(WriteDbc, HeartbeatEmcyAndNmtHaveValueNames) {
    const Database data = database_of(good_sheet(), 5);
    const Message& heartbeat = data.messages.at(0x705);
    EXPECT_EQ(heartbeat.length, 1U);
    EXPECT_THAT(places(heartbeat), ElementsAre("State 0|7+", "Toggle 7|1+"));
    EXPECT_EQ(heartbeat.signals.at("State").words,
              (std::map<unsigned, std::string>{
                  {0, "boot-up"}, {4, "stopped"}, {5, "operational"}, {127, "pre-operational"}}));
    EXPECT_THAT(places(data.messages.at(0x085)),
                ElementsAre("ErrorCode 0|16+", "ErrorRegister 16|8+", "Manufacturer 24|40+"));
    EXPECT_EQ(data.messages.at(0x000).signals.at("Command").words.at(0x81), "reset node");
    EXPECT_EQ(data.messages.at(0x080).length, 0U);
    EXPECT_EQ(database_of(patched_sheet("[1019] DefaultValue=10").text, 5).messages.at(0x080).length, 1U);
}

TEST(WriteDbc, WithoutEmcyCobId1014hEmcyHasThePredefinedIdentifier) {
    EXPECT_EQ(database_of(patched_sheet("-[1014]").text, 9).messages.at(0x089).name, "box_EMCY");
}

TEST(WriteDbc, LongDeviceNameIsCutInMessageNames_TheServiceStaysWhole) {
    EdsResult read = read_eds(good_sheet(), "box.eds");
    read.part.name = "AcmeMotorController_AMC4000_V1_23_rev4";
    const Database data = DbcReader{}.read(write_dbc(read.part, 5));
    EXPECT_EQ(data.faults, "");
    EXPECT_THAT(data.nodes, ElementsAre("Host", "AcmeMotorController_AMC4000_V1_2"));  // 32 characters
    // `_SDO_response` has 13 characters, so 32 - 13 = 19 remain for the device.
    std::map<std::uint32_t, std::string> names;
    for (const auto& [id, message] : data.messages) {
        names[id] = message.name;
    }
    EXPECT_EQ(names, (std::map<std::uint32_t, std::string>{{0x000, "AcmeMotorController_NMT"},
                                                           {0x080, "AcmeMotorController_SYNC"},
                                                           {0x085, "AcmeMotorController_EMCY"},
                                                           {0x185, "AcmeMotorController_TPDO1"},
                                                           {0x205, "AcmeMotorController_RPDO1"},
                                                           {0x305, "AcmeMotorController_RPDO2"},
                                                           {0x585, "AcmeMotorController_SDO_response"},
                                                           {0x605, "AcmeMotorController_SDO_request"},
                                                           {0x705, "AcmeMotorController_Heartbeat"}}));
    read.part.name = std::string(19, 'a') + "b";
    EXPECT_EQ(DbcReader{}.read(write_dbc(read.part, 5)).messages.at(0).name, std::string(19, 'a') + "_NMT");
}

TEST(WriteDbc, DisabledOrDuplicateMessagesAreLeftOutAndListedInTheDbcComment) {
    const EdsResult read = read_eds(patched_sheet("[1400sub1] DefaultValue=$NODEID+0x80000200 | "
                                                  "[1401sub1] DefaultValue=$NODEID+0x180")
                                        .text,
                                    "box.eds");
    const std::string text = write_dbc(read.part, 5);
    const Database data = DbcReader{}.read(text);
    EXPECT_EQ(data.faults, "");
    EXPECT_EQ(data.messages.count(0x205), 0U);
    EXPECT_EQ(data.messages.at(0x185).name, "box_RPDO2");
    EXPECT_THAT(text, HasSubstr("left out: RPDO1 is switched off, TPDO1 has the identifier of another message\";\n"));
}

TEST(WriteDbc, IdentifierOf29BitsIsMarked) {
    const Database data = database_of(patched_sheet("[1800sub1] DefaultValue=0x38000180").text, 5);
    EXPECT_EQ(data.messages.at(0x80000000U + 0x18000180U).name, "box_TPDO1");
}

TEST(WriteDbc, DbcOfEveryDeviceFollowsTheFormat) {
    for (const Part& part : built_in_register().parts) {
        if (part.is_device()) {
            const Database data = DbcReader{}.read(write_dbc(part, 3));
            EXPECT_EQ(data.faults, "") << part.name;
            EXPECT_EQ(data.messages.count(0x703), 1U) << part.name;
        }
    }
}

TEST(WriteDbc, AnalogOutputsOfTheAo412AreFourSignedWords) {
    const Database data = DbcReader{}.read(write_dbc(*built_in_register().part("cbx-ao412"), 3));
    const Message& pdo = data.messages.at(0x303);  // RPDO 2: 300h + 3
    EXPECT_EQ(pdo.length, 8U);
    std::set<std::string> found;
    for (const auto& [name, signal] : pdo.signals) {
        found.insert(place(signal));
    }
    EXPECT_EQ(found, (std::set<std::string>{"0|16-", "16|16-", "32|16-", "48|16-"}));
}

TEST(DbcNames, DbcNamesAreUniqueIdentifiersOfAtMost32Characters) {
    DbcNames names;
    EXPECT_EQ(names.take("Write output 8-bit (%)"), "Write_output_8_bit");
    EXPECT_EQ(names.take("Write output 8-bit"), "Write_output_8_bit_2");
    EXPECT_EQ(names.take("8 bit"), "n8_bit");
    EXPECT_EQ(names.take("\xC2\xB0"), "n");
    EXPECT_EQ(names.take("VERSION"), "VERSION_2");
    EXPECT_EQ(names.take(std::string(40, 'x')), std::string(32, 'x'));
    EXPECT_EQ(names.take(std::string(41, 'x')), std::string(30, 'x') + "_2");
}

TEST(DbcNames, DbcNamesDifferInMoreThanTheirCase) {
    DbcNames names;  // SavvyCAN looks names up without regard to case
    EXPECT_EQ(names.take("Speed"), "Speed");
    EXPECT_EQ(names.take("SPEED"), "SPEED_2");
    EXPECT_EQ(names.take("speed 2"), "speed_2_2");
}

TEST(DbcText, DbcStringsContainNoQuotationMark) {
    DbcFile file;
    file.nodes = {"Host"};
    file.comment = "a \"b\"\n\\ \xC2\xB0";
    EXPECT_EQ(dbc_text(file), "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: Host\n\nCM_ \"a 'b' ' ??\";\n");
}

}  // namespace canproof::host::test
