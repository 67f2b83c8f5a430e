// SPDX-License-Identifier: Apache-2.0
// Tests whether measurements of the evidence pack count as fresh or stale, and how its hand-written files are read.
#include "host/assess/evidence/freshness.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host::test {

namespace {

using ::testing::HasSubstr;

}  // namespace

TEST(Freshness, MeasurementNewerThanItsSourcesIsFresh) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness";
    fs::create_directories(root / "spec");
    const auto now = fs::file_time_type::clock::now();
    const auto write = [&](const char* name, std::chrono::seconds age) {
        std::ofstream{root / name} << name;
        fs::last_write_time(root / name, now - age);
    };
    write("measured.json", std::chrono::seconds{10});
    write("spec/old.toml", std::chrono::seconds{20});
    EXPECT_EQ(newer_source(root, {"spec", "nowhere"}, root / "measured.json"), "");
    write("spec/reviews.toml", std::chrono::seconds{5});
    EXPECT_EQ(newer_source(root, {"spec"}, root / "measured.json"), "");
    write("spec/b.toml", std::chrono::seconds{5});
    write("spec/a.toml", std::chrono::seconds{1});
    EXPECT_EQ(newer_source(root, {"spec"}, root / "measured.json"), "spec/a.toml");
    EXPECT_EQ(newer_source(root, {"spec"}, root / "never.json"), "");
    EXPECT_EQ(oldest_file(root / "spec").string(), (root / "spec/old.toml").string());
    fs::remove_all(root);
    EXPECT_EQ(oldest_file(root).string(), "");
}

TEST(Freshness, FreshMeasurementStaysFreshWhileContentsAreUnchanged) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness_of_contents";
    fs::remove_all(root);
    fs::create_directories(root / "spec");
    fs::create_directories(root / "build");
    const fs::path measured = root / "build/measured.json";
    const auto now = fs::file_time_type::clock::now();
    const auto write = [&](const fs::path& file, const char* text, std::chrono::seconds age) {
        std::ofstream{file} << text;
        fs::last_write_time(file, now - age);
    };
    write(root / "spec/a.toml", "one", std::chrono::seconds{20});
    write(measured, "figures", std::chrono::seconds{10});
    const auto changed = [&] { return changed_source(root, {"spec"}, measured); };
    EXPECT_EQ(changed(), "");
    // The file was written again with the same contents: nothing has changed, whatever its time.
    write(root / "spec/a.toml", "one", std::chrono::seconds{1});
    EXPECT_EQ(changed(), "");
    // The file has other contents and an old time.
    write(root / "spec/a.toml", "two", std::chrono::seconds{30});
    EXPECT_EQ(changed(), "spec/a.toml");
    write(root / "spec/a.toml", "one", std::chrono::seconds{1});
    write(root / "spec/b.toml", "new", std::chrono::seconds{30});
    EXPECT_EQ(changed(), "spec/b.toml");
    fs::remove(root / "spec/b.toml");
    EXPECT_EQ(changed(), "");
    fs::remove(root / "spec/a.toml");
    EXPECT_EQ(changed(), "spec/a.toml");
    // No hashes of sources are recorded for the new contents of the measurement, so the times of the files decide.
    write(root / "spec/a.toml", "two", std::chrono::seconds{1});
    write(measured, "other figures", std::chrono::seconds{10});
    EXPECT_EQ(changed(), "spec/a.toml");
    write(measured, "other figures", std::chrono::seconds{0});
    EXPECT_EQ(changed(), "");
    fs::remove_all(root);
}

TEST(Freshness, FirmwareOfDevicesCountsAsASourceOfAMeasurement) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness_of_devices";
    const fs::path file = "src/devices/ax130751/firmware/ramp.cpp";
    fs::create_directories((root / file).parent_path());
    std::ofstream{root / "measured.json"} << "measured";
    std::ofstream{root / file} << "code";
    const auto measured = fs::last_write_time(root / "measured.json");
    fs::last_write_time(root / file, measured - std::chrono::seconds{1});
    for (const auto& sources :
         {firmware_sources(root), firmware_and_tests(root), socketcan_sources(root), target_sources(root)}) {
        EXPECT_EQ(newer_source(root, sources, root / "measured.json"), "");
    }
    fs::last_write_time(root / file, measured + std::chrono::seconds{1});
    for (const auto& sources :
         {firmware_sources(root), firmware_and_tests(root), socketcan_sources(root), target_sources(root)}) {
        EXPECT_EQ(newer_source(root, sources, root / "measured.json"), file.generic_string());
    }
    fs::remove_all(root);
}

TEST(Freshness, EvidenceIsStaleAfterAChangeOfAFileThatItsToolReads) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "freshness_of_exhibits";
    // For each file, the exhibits (results of tools) that are out of date when it has changed. The others stay fresh.
    const std::vector<std::pair<const char*, std::vector<std::string>>> cases{
        {"misra/deviations.toml", {"misra"}},
        {"misra/reviews.toml", {"misra"}},
        {"fuzz/sdo_server_fuzz.cpp", {"fuzz", "object_coverage"}},
        {"fuzz/corpus/sdo_server/one", {}},
        {"tests/coupling/run", {"code-mutation", "coupling", "object_coverage"}},
        {"tests/devices/box/box_test.cpp", {"code-mutation", "faults", "object_coverage"}},
        {"tests/bench/count", {"code-mutation", "growth", "instructions", "object_coverage", "scale"}},
        {"tests/socketcan/run", {"code-mutation", "object_coverage", "socketcan_arm"}},
        {"src/host/conform/link/sdo_client.cpp", {"socketcan_arm"}},
        {"properties/invariants/sync.cpp", {"code-mutation", "object_coverage", "proofs"}},
        {"properties/proofs/crc.cpp", {"code-mutation", "object_coverage", "proofs"}},
        {"src/target/startup.cpp", {"faults", "object_coverage", "socketcan_arm", "worst_case"}},
        {"src/target/image/image.hpp", {"coupling", "faults", "object_coverage", "socketcan_arm", "worst_case"}},
        {"src/devices/box/target/wiring.hpp", {"coupling", "faults", "misra", "object_coverage", "worst_case"}},
        {"src/devices/box/target/bounds.toml", {"coupling", "faults", "misra", "object_coverage", "worst_case"}},
        {"src/host/sim/run/node.cpp", {"growth", "scale", "socketcan_arm"}},
        {"src/firmware/base/README.md", {}},
        {"spec/devices/box/reviews.toml", {}},
        {"src/firmware/base/bytes.cpp",
         {"code-mutation", "coupling", "faults", "fuzz", "growth", "instructions", "misra", "object_coverage", "other",
          "proofs", "scale", "socketcan_arm", "worst_case"}}};
    for (const auto& [file, expected] : cases) {
        fs::remove_all(root);
        fs::create_directories((root / file).parent_path());
        std::ofstream{root / "measured.json"} << "measured";
        std::ofstream{root / file} << "changed";
        fs::last_write_time(root / file, fs::last_write_time(root / "measured.json") + std::chrono::seconds{1});
        std::vector<std::string> stale;
        for (const char* key : {"code-mutation", "coupling", "faults", "fuzz", "growth", "instructions", "misra",
                                "object_coverage", "other", "proofs", "scale", "socketcan_arm", "worst_case"}) {
            if (!newer_source(root, exhibit_sources(root, key), root / "measured.json").empty()) {
                stale.emplace_back(key);
            }
        }
        EXPECT_EQ(stale, expected) << file;
    }
    fs::remove_all(root);
}

TEST(Verdicts, TestResultsOfTheLatestRunAreUsed) {
    namespace fs = std::filesystem;
    const fs::path root = fs::path{::testing::TempDir()} / "verdicts";
    EXPECT_EQ(newest_verdicts(root).string(), (root / "build/release/verdicts").string());
    const auto now = fs::file_time_type::clock::now();
    const auto run = [&](const char* preset, std::chrono::seconds age) {
        const fs::path folder = root / "build" / preset / "verdicts";
        fs::create_directories(folder);
        std::ofstream{folder / "tests.xml"} << "<testsuites/>";
        fs::last_write_time(folder / "tests.xml", now - age);
        return folder.string();
    };
    run("release", std::chrono::seconds{30});
    const std::string coverage = run("coverage", std::chrono::seconds{10});
    run("debug", std::chrono::seconds{20});
    run("mutation", std::chrono::seconds{1});  // the newest run, but its test results come from altered tables
    EXPECT_EQ(newest_verdicts(root).string(), coverage);
    fs::remove_all(root);
}

TEST(ArgumentFile, ValidArgumentIsReadAndInvalidOnesAreReportedWithTheirLine) {
    const auto file = std::filesystem::path{::testing::TempDir()} / "argument.toml";
    const auto told = [&](const char* text) {
        std::ofstream{file} << text;
        try {
            return std::to_string(read_argument(file).claims.size());
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
    };
    EXPECT_EQ(told("[[claim]]\nid = \"C\"\ntext = \"t\"\n[[claim]]\nid = \"D\"\nparent = \"C\"\ntext = \"t\"\n"), "2");
    EXPECT_THAT(told("[[claim]]\nid = \"C\"\nparent = \"B\"\ntext = \"t\"\n"),
                HasSubstr("argument.toml:3: there is no claim `B` above this claim"));
    EXPECT_THAT(told("[[claim\n"), HasSubstr("argument.toml:1: "));
    std::filesystem::remove(file);
}

TEST(Techniques, TablesOfSafetyTechniquesAreReadFromAFolder_AndInvalidRowsAreReportedWithTheirLine) {
    const auto folder = std::filesystem::path{::testing::TempDir()} / "techniques";
    std::filesystem::create_directories(folder);
    std::ofstream{folder / "README.md"} << "a file of another kind";
    const auto told = [&](const char* row) {
        std::ofstream{folder / "a.toml"} << "[[table]]\ntable = \"T\"\ntitle = \"t\"\nrows = [\"" << row << "\"]\n";
        try {
            const auto all = read_techniques(folder);
            std::string exhibits;
            for (const auto& key : all.empty() ? std::vector<std::string>{} : all[0].exhibits) {
                exhibits += "/" + key;
            }
            return all.size() == 1 ? all[0].table + "/" + all[0].number + "/" + all[0].name + "/" + all[0].level + "/" +
                                         all[0].state + "/" + all[0].how + exhibits
                                   : std::to_string(all.size());
        } catch (const InputError& error) {
            return std::string{error.what()};
        }
    };
    EXPECT_THAT(told("1a | a name | HR | shown | here | there"), HasSubstr("has 6 fields"));
    EXPECT_EQ(told("1a | a name | HR | shown | here"), "T/1a/a name/HR/shown/here");
    EXPECT_EQ(told("1a | a name | HR | shown: coverage, fuzz | here"), "T/1a/a name/HR/shown/here/coverage/fuzz");
    EXPECT_THAT(told("1a | a name | HR | shown coverage | here"), HasSubstr("`shown coverage` is no state"));
    EXPECT_THAT(told("1a | a name | HR | shown"), HasSubstr("a.toml:4: `1a | a name | HR | shown` has 4 fields"));
    EXPECT_THAT(told("1a | a name | HR | maybe | here"), HasSubstr("a.toml:4: `maybe` is no state"));
    std::filesystem::remove_all(folder);
    EXPECT_TRUE(read_techniques(folder).empty());
}

}  // namespace canproof::host::test
