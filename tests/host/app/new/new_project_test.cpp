// SPDX-License-Identifier: Apache-2.0
// Tests the files that `canproof new` writes, and the options that it refuses.
#include "host/app/new/new_project.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/base/input_error.hpp"
#include "host/register/advice.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

NewProject project_named(const std::string& name) {
    NewProject project;
    project.name = name;
    project.date = "2026-11-22";
    return project;
}

LoadResult register_of(const std::map<std::string, std::string>& files) {
    SpecFiles spec;
    for (const auto& [path, text] : files) {
        if (path.rfind("spec/", 0) == 0) {
            spec.emplace(path, text);
        }
    }
    return load_register(with_shared_rules(std::move(spec), embedded_spec()));
}

bool refuses(const NewProject& project) {
    try {
        project_files(project);
        return false;
    } catch (const InputError&) {
        return true;
    }
}

/// Returns a data sheet with one object of each kind.
Part small_sheet() {
    Part part;
    part.info.node_id = 9;
    part.info.bit_rate = 250000;
    part.info.vendor = "Maker \"A\"";
    Object type;
    type.index = 0x1000;
    type.name = "Device Type";
    Entry entry;
    entry.type = "UNSIGNED32";
    entry.access = "ro";
    entry.value = std::int64_t{0x191};
    type.entries = {entry};
    Object list;
    list.index = 0x2000;
    list.name = "Back\\slash \"quote\"";
    list.kind = Object::Kind::array;
    Entry zero;
    zero.type = "UNSIGNED8";
    zero.access = "const";
    zero.name = "Highest sub-index";
    zero.value = std::int64_t{1};
    Entry one;
    one.subindex = 1;
    one.type = "REAL32";
    one.access = "rw";
    one.stored = true;
    one.name = "Gain";
    one.value = 2.0;
    list.entries = {zero, one};
    part.objects = {type, list};
    return part;
}

}  // namespace

TEST(NewProject, NewProjectHasAValidRegisterWithOneDevice) {
    const LoadResult loaded = register_of(project_files(project_named("my-box")));
    EXPECT_TRUE(loaded.faults.empty()) << loaded.faults.front().text();
    const Part* const device = loaded.content.part("my-box");
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(device->prefix, "MYBOX");
    EXPECT_EQ(device->tables.size(), 2U);
    EXPECT_EQ(device->decisions.size(), 1U);
    EXPECT_EQ(device->requirements.size(), 6U);
    EXPECT_TRUE(advice_on(loaded.content).empty()) << advice_on(loaded.content).front().text();
    EXPECT_TRUE(device->info.lss);
    EXPECT_TRUE(loaded.content.part("canopen")->inherited);
}

TEST(NewProject, TemplatePlaceholdersAreAllReplaced) {
    for (const auto& [path, text] : project_files(project_named("my-box"))) {
        for (const char* mark :
             {"@name@", "@word@", "@prefix@", "@title@", "@Type@", "@emergency@", "@bit_rates@", "@boot_id@"}) {
            EXPECT_EQ(path.find(mark), std::string::npos) << path;
            EXPECT_EQ(text.find(mark), std::string::npos) << path;
        }
    }
}

TEST(NewProject, InvalidNamesAreRefused) {
    for (const char* name : {"", "Box", "1box", "-box", "box-", "a--b", "a_b", "../box", "a/b", "int", "canopen",
                             "abcdefghijabcdefghijabcdefghijabcdefghija"}) {
        EXPECT_TRUE(refuses(project_named(name))) << name;
    }
    EXPECT_FALSE(refuses(project_named("box-2")));
}

TEST(NewProject, InvalidAndAlreadyUsedItemIdPrefixesAreRefused) {
    for (const char* prefix : {"CO", "ab", "1A", "A-B", "A B"}) {
        NewProject project = project_named("box");
        project.prefix = prefix;
        EXPECT_TRUE(refuses(project)) << prefix;
    }
}

TEST(NewProject, NodeIdBitRateAndObjectsComeFromTheDataSheet) {
    NewProject project = project_named("box");
    project.eds = small_sheet();
    const LoadResult loaded = register_of(project_files(project));
    ASSERT_TRUE(loaded.faults.empty()) << loaded.faults.front().text();
    const Part& device = *loaded.content.part("box");
    EXPECT_EQ(device.info.node_id, 9);
    EXPECT_EQ(device.info.bit_rate, 250000);
    ASSERT_EQ(device.objects.size(), 2U);
    EXPECT_EQ(device.objects[0].entries.front().value, Value{std::int64_t{0x191}});
    EXPECT_EQ(device.objects[1].name, "Back\\slash \"quote\"");
    ASSERT_EQ(device.objects[1].entries.size(), 2U);
    EXPECT_EQ(device.objects[1].entries[1].value, Value{2.0});
    EXPECT_TRUE(device.objects[1].entries[1].stored);
}

/// Returns the frame that the generated error test expects of node 5 when the data sheet has 1014h (COB-ID EMCY) with
/// this default.
std::string expected_emergency(std::int64_t value, bool node_id) {
    NewProject project = project_named("box");
    project.eds = small_sheet();
    Object cob_id;
    cob_id.index = 0x1014;
    cob_id.name = "COB-ID EMCY";
    Entry entry;
    entry.type = "UNSIGNED32";
    entry.access = "rw";
    entry.value = value;
    entry.node_id = node_id;
    cob_id.entries = {entry};
    project.eds->objects.push_back(cob_id);
    const std::string text = project_files(project).at("tests/devices/box/errors_test.cpp");
    const auto at = text.find("return {");
    return text.substr(at, text.find(';', at) - at);
}

TEST(NewProject, GeneratedTestExpectsEmcyWithTheCobIdOfTheDataSheet) {
    EXPECT_EQ(expected_emergency(0x80, true), "return {\"085#\" + bytes}");
    EXPECT_EQ(expected_emergency(0x123, false), "return {\"123#\" + bytes}");
    EXPECT_EQ(expected_emergency(0x80000080, true), "return {}");
}

TEST(NewProject, BitRateOfTheDataSheetIsAmongThoseOfTheNewProject) {
    NewProject project = project_named("box");
    project.eds = small_sheet();
    project.eds->info.bit_rate = 100000;
    const LoadResult loaded = register_of(project_files(project));
    ASSERT_TRUE(loaded.faults.empty()) << loaded.faults.front().text();
    const auto& rates = loaded.content.part("box")->info.bit_rates;
    EXPECT_EQ(std::count(rates.begin(), rates.end(), 100000), 1);
}

}  // namespace canproof::host
