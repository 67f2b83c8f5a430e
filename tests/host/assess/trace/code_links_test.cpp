// SPDX-License-Identifier: Apache-2.0
// Tests the search for firmware files that no requirement reaches, and for the places where code uses a name that is
// generated from an item of the register.
#include "host/assess/trace/code_links.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace canproof::host {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

class CodeLinks : public testing::Test {
  protected:
    CodeLinks() : root_{fs::path{testing::TempDir()} / "code_links"} { fs::remove_all(root_); }
    ~CodeLinks() override { fs::remove_all(root_); }

    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream{root_ / file} << text;
    }
    std::vector<std::string> untraced(const std::string& implementing) const {
        Evidence evidence;
        evidence.implemented["D-1"] = {implementing + ":7"};
        return untraced_files(root_ / "src", evidence);
    }

    fs::path root_;
};

TEST_F(CodeLinks, FirmwareFileWithoutARequirementIsUntraced) {
    write("src/devices/d-1/firmware/d.cpp", "#include \"devices/d-1/firmware/ramp.hpp\"\n");
    write("src/devices/d-1/firmware/ramp.hpp", "#include \"firmware/base/time.hpp\"\n");
    write("src/devices/d-1/firmware/ramp.cpp", "\n");
    write("src/devices/d-1/firmware/stray.cpp", "\n");
    write("src/devices/d-1/simulation/model.cpp", "\n");
    write("src/firmware/base/time.hpp", "\n");
    write("src/firmware/base/stray.hpp", "\n");
    EXPECT_THAT(untraced("src/devices/d-1/firmware/d.cpp"),
                ElementsAre("src/devices/d-1/firmware/stray.cpp", "src/firmware/base/stray.hpp"));
}

TEST_F(CodeLinks, FilesIncludedByGeneratedCodeAreTraced) {
    write("src/host/codegen/write_tables.cpp", "    text += \"#include \\\"firmware/base/table.hpp\\\"\\n\";\n");
    write("src/host/sim/write_other.cpp", "    text += \"#include \\\"firmware/base/other.hpp\\\"\\n\";\n");
    write("src/firmware/base/table.hpp", "\n");
    write("src/firmware/base/other.hpp", "\n");
    EXPECT_THAT(untraced("src/firmware/base/none.cpp"), ElementsAre("src/firmware/base/other.hpp"));
}

TEST_F(CodeLinks, SignalNamesInADeviceFolderReferToThatDevice) {
    Part part;
    part.name = "d-1";
    Signal signal;
    signal.id = "D-SIG-gain";
    signal.name = "gain";
    part.signals = {signal};
    Register content;
    content.parts = {part};
    write("src/devices/d-1/simulation/model.cpp", "// gain\nint gain{1};\nint again{gain};\n");
    write("src/firmware/base/other.cpp", "int gain{1};\n");
    EXPECT_THAT(generated_uses(root_, content),
                ElementsAre(Pair("D-SIG-gain", ElementsAre("src/devices/d-1/simulation/model.cpp:2"))));
    write("src/devices/d-1/simulation/model.cpp", "// gain\n");
    EXPECT_THAT(generated_uses(root_, content), IsEmpty());
}

TEST_F(CodeLinks, FirmwareThatPassesGeneratedTablesToItsNodeCountsAsUsingThem) {
    Part part;
    part.name = "d-1";
    part.info.lss_bit_rates = "D-T2";
    Column code;
    code.enumeration = "D-E";
    part.tables.resize(2);
    part.tables[0].id = "D-T1";
    part.tables[0].errors = "error";
    part.tables[0].outputs = {code};
    part.tables[1].id = "D-T2";
    Register content;
    content.parts = {part};
    write("src/devices/d-1/firmware/d.cpp", "\nNode node{own::error_table, own::profile};\n");
    const auto here = ElementsAre("src/devices/d-1/firmware/d.cpp:2");
    EXPECT_THAT(generated_uses(root_, content), ElementsAre(Pair("D-E", here), Pair("D-T1", here), Pair("D-T2", here)));
}

}  // namespace
}  // namespace canproof::host
