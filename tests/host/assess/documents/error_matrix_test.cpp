// SPDX-License-Identifier: Apache-2.0
// Tests which requirements the error matrix lists for an emergency code.
#include "host/assess/documents/error_matrix.hpp"

#include <gmock/gmock.h>

namespace canproof::host::test {

namespace {

class ErrorMatrix : public ::testing::Test {
  protected:
    /// Returns the column of requirements for an error with this code, when one requirement with this text exists.
    static std::string found(const std::int64_t code, const std::string& text, const std::uint16_t object = 0x2000) {
        Register content;
        Part part;
        part.name = "box";
        Requirement requirement;
        requirement.id = "B-001";
        requirement.text = text;
        part.requirements = {requirement};
        part.objects.resize(1);
        part.objects[0].index = object;
        Table errors;
        errors.errors = "error";
        errors.inputs.resize(1);
        errors.inputs[0].name = "error";
        errors.outputs.resize(1);
        errors.outputs[0].name = "code";
        errors.rows = {{{Cell{{{std::string{"supply"}, {}, false}}}, Cell{{{code, {}, true}}}}, {}}};
        part.tables = {errors};
        content.parts = {part};
        return error_matrix(content, part, {}).chapters.at(0).tables.at(0).rows.at(0).at(4);
    }
};

}  // namespace

TEST_F(ErrorMatrix, CodeAloneIsFound) {
    EXPECT_EQ(found(0x3100, "Below 9 V, the device shall raise error 3100h."), "B-001");
    EXPECT_EQ(found(0x4200, "When error 4200h (temperature) or FF00h (sensor) begins, it shall send."), "B-001");
    EXPECT_EQ(found(0xFF00, "When error 4200h (temperature) or FF00h (sensor) begins, it shall send."), "B-001");
    EXPECT_EQ(found(0x0000, "It shall send an emergency message with code 0000h."), "B-001");
    EXPECT_EQ(found(0x3110, "Below 9 V, the device shall raise error 3100h."), "missing");
}

TEST_F(ErrorMatrix, ObjectWithTheNumberOfACodeIsNoCode) {
    EXPECT_EQ(found(0x3100, "The device shall read it into 3100h (CJ Input Field Value).", 0x3100), "missing");
    EXPECT_EQ(found(0x3100, "The value is 3100h times 3126h.", 0x3100), "missing");
    EXPECT_EQ(found(0x3100, "It shall write 3100h:1."), "missing");
    EXPECT_EQ(found(0x3100, "It shall raise error 3100h while 3100h (field value) is NaN.", 0x3100), "B-001");
    EXPECT_EQ(found(0x3100, "It shall send a message with code 3100h.", 0x3100), "B-001");
}

TEST_F(ErrorMatrix, CodeInsideALongerNumberIsFoundInEntriesOfTheErrorListAlone) {
    EXPECT_EQ(found(0x8130, "The entry is 10008130h for a missing guarding request."), "B-001");
    EXPECT_EQ(found(0x8130, "The entry is 80nn8130h, where nn is the node-ID."), "B-001");
    EXPECT_EQ(found(0x0000, "The device shall answer with abort code 06060000h."), "missing");
    EXPECT_EQ(found(0x0030, "It shall refuse the value with abort code 06090030h."), "missing");
    EXPECT_EQ(found(0x0022, "The abort code is 08000022h."), "missing");
    EXPECT_EQ(found(0x0000, "The COB-ID is 80000000h."), "missing");
    EXPECT_EQ(found(0x8130, "It counts to 18130h."), "missing");
}

}  // namespace canproof::host::test
