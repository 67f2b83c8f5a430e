// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "host/assess/trace/code_links.hpp"
#include "host/assess/trace/link_places.hpp"
#include "host/base/input_error.hpp"
#include "host/base/lines.hpp"

namespace canproof::host {

namespace {

std::string id_of(std::string cpp_name) {
    std::replace(cpp_name.begin(), cpp_name.end(), '_', '-');
    return cpp_name;
}

/// Returns the path of a test's source relative to the project's folder: `tests/NAME_test.cpp` for a path such as
/// `../../tests/NAME_test.cpp`, as the build writes it.
std::string from_project(std::string file) {
    for (const char* folder : {"tests/", "properties/", "fuzz/"}) {
        const auto at = file.find(folder);
        if (at != std::string::npos && (at == 0 || file[at - 1] == '/')) {
            return file.substr(at);
        }
    }
    return file;
}

void read_verdicts(const std::filesystem::path& file, Evidence& evidence) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) {
        throw InputError{fmt::format("{} cannot be read as XML; run the tests again", file.string())};
    }
    const auto cases = document.select_nodes("//testcase");
    for (const auto& node : cases) {
        const pugi::xml_node one = node.node();
        const bool ran = std::string{one.attribute("status").value()} == "run";
        const bool passed = ran && !one.child("failure");
        ++evidence.tests;
        evidence.failed += passed ? 0 : 1;
        const std::string name =
            fmt::format("{}.{}", one.attribute("classname").value(), one.attribute("name").value());
        const std::string source = from_project(one.attribute("file").value());
        TestCase test{one.attribute("classname").value(),
                      one.attribute("name").value(),
                      passed,
                      one.child("failure").attribute("message").value(),
                      one.attribute("time").as_double(),
                      source,
                      {}};
        for (const auto& claim : one.child("properties").children("property")) {
            evidence.verdicts[claim.attribute("name").value()].push_back({name, claim.attribute("value").value(),
                                                                          passed, test.seconds, source,
                                                                          one.attribute("line").as_uint()});
            test.items.emplace_back(claim.attribute("name").value());
        }
        evidence.runs.push_back({name, source, passed, !test.items.empty()});
        evidence.cases.push_back(std::move(test));
    }
}

/// Adds to `evidence` the ids that implements<req::…> names in a line of code. Ignores a comment at the end of the
/// line.
void scan_line(const std::string& line, const std::string& place, Evidence& evidence) {
    static const std::string link = "implements<req::";
    const auto comment = line.find("//");
    for (auto at = line.find(link); at < comment; at = line.find(link, at)) {
        at += link.size();
        const auto end = line.find('>', at);
        if (end != std::string::npos) {
            evidence.implemented[id_of(line.substr(at, end - at))].push_back(place);
        }
    }
}

void scan_source(const std::filesystem::path& root, const std::filesystem::path& file, Evidence& evidence) {
    const std::string name = file.lexically_relative(root).generic_string();
    int number = 0;
    for (const auto& line : read_lines(file)) {
        ++number;
        scan_line(line, fmt::format("{}:{}", name, number), evidence);
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

/// Returns the shared requirements that implement other requirements (`by`), by the id of the other requirement.
std::map<std::string, std::string> shared_requirements(const Register& content) {
    std::map<std::string, std::string> by;
    for (const auto& part : content.parts) {
        for (const auto& requirement : part.requirements) {
            if (!requirement.by.empty()) {
                by[requirement.id] = requirement.by;
            }
        }
    }
    return by;
}

/// Computes the review marks (hashes of code and tests) for each item of the register. For an item that a shared item
/// implements (`by`), the code is that of the shared item.
WorkByItem work_of_items(const std::filesystem::path& root, const Register& content, const Evidence& evidence,
                         WorkDetail detail) {
    WorkMarks marks{root};
    WorkByItem work;
    const auto mark = [&](const Item& item, const char*) {
        const auto code = evidence.implemented.find(implementing_id(item.id, evidence));
        const auto claims = evidence.verdicts.find(item.id);
        ItemWork now;
        if (code != evidence.implemented.end()) {
            now.code = marks.of_code(code->second);
            if (detail == WorkDetail::parts) {
                now.functions = marks.functions(code->second);
            }
        }
        if (claims != evidence.verdicts.end()) {
            std::vector<std::pair<std::string, std::string>> tests;
            for (const auto& verdict : claims->second) {
                if (verdict.kind != "proof") {  // a proven theorem is no test with a body to review
                    tests.emplace_back(verdict.file, verdict.test);
                }
            }
            now.tests = marks.of_tests(tests);
            if (detail == WorkDetail::parts) {
                now.bodies = marks.bodies(tests);
            }
        }
        if (!now.code.empty() || !now.tests.empty()) {
            work[item.id] = now;
        }
    };
    for (const auto& part : content.parts) {
        if (!part.inherited) {
            content.for_each_item(part, mark);
        }
    }
    return work;
}

}  // namespace

const std::string& implementing_id(const std::string& id, const Evidence& evidence) {
    const auto shared = evidence.implemented_by.find(id);
    return shared == evidence.implemented_by.end() ? id : shared->second;
}

Evidence read_verdict_file(const std::filesystem::path& file) {
    Evidence evidence;
    read_verdicts(file, evidence);
    return evidence;
}

Evidence read_verdict_files(const std::filesystem::path& verdicts) {
    Evidence evidence;
    for (const auto& file : files_below(verdicts, {".xml"})) {
        read_verdicts(file, evidence);
    }
    return evidence;
}

std::filesystem::path newest_verdicts(const std::filesystem::path& root) {
    std::filesystem::path newest = root / "build" / "release" / "verdicts";
    std::filesystem::file_time_type time = std::filesystem::file_time_type::min();
    for (const char* preset : {"release", "debug", "coverage"}) {
        const auto folder = root / "build" / preset / "verdicts";
        const auto file = folder / "tests.xml";
        if (std::filesystem::exists(file) && std::filesystem::last_write_time(file) > time) {
            newest = folder;
            time = std::filesystem::last_write_time(file);
        }
    }
    return newest;
}

Evidence collect_evidence(const std::filesystem::path& root, const std::filesystem::path& verdicts,
                          const Register& content, WorkDetail detail) {
    Evidence evidence = read_verdict_files(verdicts);
    if (evidence.tests == 0) {
        throw InputError{fmt::format("{} contains no test results; run ./test first, or name a folder with --verdicts",
                                     verdicts.string())};
    }
    for (const auto& file : files_below(root / "src", {".hpp", ".cpp"})) {
        scan_source(root, file, evidence);
    }
    evidence.implemented_by = shared_requirements(content);
    evidence.work = work_of_items(root, content, evidence, detail);
    evidence.used = generated_uses(root, content);
    evidence.untraced = untraced_files(root / "src", evidence);
    evidence.misplaced = misplaced_links(root);
    return evidence;
}

}  // namespace canproof::host
