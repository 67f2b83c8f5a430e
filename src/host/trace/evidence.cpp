#include "host/trace/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <pugixml.hpp>
#include <regex>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

std::string id_of(std::string cpp_name) {
    std::replace(cpp_name.begin(), cpp_name.end(), '_', '-');
    return cpp_name;
}

void read_verdicts(const std::filesystem::path& file, Evidence& evidence) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) {
        throw InputError{fmt::format("{} is no XML; run the tests again", file.string())};
    }
    const auto cases = document.select_nodes("//testcase");
    for (const auto& node : cases) {
        const pugi::xml_node one = node.node();
        const bool ran = std::string{one.attribute("status").value()} == "run";
        const bool passed = ran && !one.child("failure");
        ++evidence.tests;
        evidence.failed += passed ? 0 : 1;
        evidence.cases.push_back({one.attribute("classname").value(), one.attribute("name").value(), passed,
                                  one.child("failure").attribute("message").value()});
        const std::string name =
            fmt::format("{}.{}", one.attribute("classname").value(), one.attribute("name").value());
        for (const auto& claim : one.child("properties").children("property")) {
            evidence.verdicts[claim.attribute("name").value()].push_back(
                {name, claim.attribute("value").value(), passed});
        }
    }
}

void scan_source(const std::filesystem::path& root, const std::filesystem::path& file, Evidence& evidence) {
    static const std::regex link{R"(implements<req::(\w+)>)"};
    std::ifstream in{file};
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        for (std::sregex_iterator at{line.begin(), line.end(), link}, end; at != end; ++at) {
            evidence.implemented[id_of((*at)[1])].push_back(
                fmt::format("{}:{}", file.lexically_relative(root).generic_string(), number));
        }
    }
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder,
                                               const std::set<std::string>& endings) {
    std::vector<std::filesystem::path> all;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
            if (file.is_regular_file() && endings.count(file.path().extension().string()) != 0) {
                all.push_back(file.path());
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

Evidence collect_evidence(const std::filesystem::path& root, const std::filesystem::path& verdicts) {
    Evidence evidence;
    for (const auto& file : files_below(verdicts, {".xml"})) {
        read_verdicts(file, evidence);
    }
    if (evidence.tests == 0) {
        throw InputError{fmt::format(
            "no test results in {}; run ./run or ctest first, or name a folder with --verdicts", verdicts.string())};
    }
    for (const auto& file : files_below(root / "src" / "firmware", {".hpp", ".cpp"})) {
        scan_source(root, file, evidence);
    }
    return evidence;
}

}  // namespace canproof::host
