// SPDX-License-Identifier: Apache-2.0
// The good data sheet (one without findings), and the patches that change it.
#include "tests/host/datasheet/check/good_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace canproof::host::test {

namespace {

/// Writes object sections and lists them.
class Writer {
  public:
    void var(unsigned index, const std::string& name, unsigned type, const std::string& access,
             const std::string& value, const std::string& more = "PDOMapping=0\n") {
        list(index);
        text_ += fmt::format("[{:04X}]\nParameterName={}\nObjectType={}\n", index, name, type == 15 ? "0x2" : "0x7") +
                 values(type, access, value) + more;
    }
    void several(unsigned index, const std::string& name, unsigned code, unsigned count) {
        list(index);
        text_ += fmt::format("[{:04X}]\nParameterName={}\nObjectType=0x{}\nSubNumber={}\n", index, name, code, count);
        index_ = index;
    }
    void sub(unsigned sub, unsigned type, const std::string& access, const std::string& value,
             const std::string& more = "PDOMapping=0\n") {
        text_ += fmt::format("[{:04X}sub{:X}]\nParameterName=Entry {}\nObjectType=0x7\n", index_, sub, sub) +
                 values(type, access, value) + more;
    }
    void raw(const std::string& text) { text_ += text; }
    void list(unsigned index) {
        const bool mandatory = index == 0x1000 || index == 0x1001 || index == 0x1018;
        lists_.at(mandatory ? 0 : index >= 0x2000 && index < 0x6000 ? 2 : 1).push_back(index);
    }
    std::string text() const {
        constexpr std::array<const char*, 3> names{"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"};
        std::string all = text_;
        for (std::size_t i = 0; i < names.size(); ++i) {
            all += fmt::format("[{}]\nSupportedObjects={}\n", names.at(i), lists_.at(i).size());
            for (std::size_t k = 0; k < lists_.at(i).size(); ++k) {
                all += fmt::format("{}=0x{:04X}\n", k + 1, lists_.at(i)[k]);
            }
        }
        return all;
    }

  private:
    static std::string values(unsigned type, const std::string& access, const std::string& value) {
        return fmt::format("DataType=0x{:04X}\nAccessType={}\n", type, access) +
               (value.empty() ? "" : "DefaultValue=" + value + "\n");
    }

    std::string text_;
    unsigned index_{0};
    std::array<std::vector<unsigned>, 3> lists_;
};

const char* const head = R"([FileInfo]
FileName=box.eds
FileVersion=1
FileRevision=2
EDSVersion=4.0
Description=A box
CreationTime=09:05AM
CreationDate=02-29-2020
CreatedBy=Nobody
ModificationTime=12:30PM
ModificationDate=03-01-2020
ModifiedBy=Nobody
[DeviceInfo]
VendorName=Nobody
VendorNumber=0x17
ProductName=Box
ProductNumber=0x2345
RevisionNumber=1
OrderCode=B.1
BaudRate_10=0
BaudRate_125=1
SimpleBootUpMaster=0
SimpleBootUpSlave=1
Granularity=8
DynamicChannelsSupported=0
GroupMessaging=0
NrOfRXPDO=2
NrOfTXPDO=1
LSS_Supported=1
[DummyUsage]
Dummy0001=0
Dummy0005=1
[Comments]
Lines=2
Line1=One
Line2=Two
)";

void write_communication(Writer& out) {
    out.var(0x1000, "Device type", 7, "ro", "0x191");
    out.var(0x1001, "Error register", 5, "ro", "0", "PDOMapping=1\n");
    out.several(0x1018, "Identity", 9, 5);
    out.sub(0, 5, "const", "4");
    out.sub(1, 7, "ro", "0x17");
    out.sub(2, 7, "ro", "0x2345");
    out.sub(3, 7, "ro", "1");
    out.sub(4, 7, "ro", "7");
    out.several(0x1003, "Errors", 8, 3);
    out.sub(0, 5, "rw", "0");
    out.sub(1, 7, "ro", "0");
    out.sub(2, 7, "ro", "0");
    out.var(0x1005, "COB-ID SYNC", 7, "rw", "0x80");
    out.var(0x1006, "Cycle period", 7, "rw", "0");
    out.var(0x1008, "Device name", 9, "const", "Box");
    out.var(0x100C, "Guard time", 6, "rw", "0");
    out.var(0x100D, "Life time factor", 5, "rw", "0");
    for (const unsigned index : {0x1010U, 0x1011U}) {
        out.several(index, "Parameters", 8, 2);
        out.sub(0, 5, "ro", "1");
        out.sub(1, 7, "rw", "1");
    }
    out.var(0x1012, "COB-ID TIME", 7, "rw", "0x80000100");
    out.var(0x1014, "COB-ID EMCY", 7, "rw", "$NODEID+0x80");
    out.var(0x1015, "Inhibit time EMCY", 6, "rw", "0");
    out.several(0x1016, "Consumer heartbeat time", 8, 3);
    out.sub(0, 5, "ro", "2");
    out.sub(1, 7, "rw", "0x00050064");
    out.sub(2, 7, "rw", "0");
    out.var(0x1017, "Producer heartbeat time", 6, "rw", "1000");
    out.var(0x1019, "SYNC counter overflow", 5, "rw", "0");
    out.several(0x1029, "Error behaviour", 8, 2);
    out.sub(0, 5, "ro", "1");
    out.sub(1, 5, "rw", "0");
    out.several(0x1200, "SDO server 1", 9, 3);
    out.sub(0, 5, "ro", "2");
    out.sub(1, 7, "ro", "$NODEID+0x600");
    out.sub(2, 7, "ro", "$NODEID+0x580");
    out.several(0x1201, "SDO server 2", 9, 3);
    out.sub(0, 5, "ro", "2");
    out.sub(1, 7, "rw", "0x80000000");
    out.sub(2, 7, "rw", "0x80000000");
}

void write_pdos(Writer& out) {
    for (const unsigned number : {0U, 1U}) {
        out.several(0x1400 + number, "RPDO", 9, 4);
        out.sub(0, 5, "ro", "3");
        out.sub(1, 7, "rw", number == 0 ? "$NODEID+0x200" : "$NODEID+0x300");
        out.sub(2, 5, "rw", "255");
        out.sub(3, 6, "rw", "0");
    }
    out.several(0x1600, "RPDO 1 mapping", 9, 3);
    out.sub(0, 5, "rw", "2");
    out.sub(1, 7, "rw", "0x62000108");
    out.sub(2, 7, "rw", "0x00050008");
    out.several(0x1601, "RPDO 2 mapping", 9, 3);
    out.sub(0, 5, "rw", "1");
    out.sub(1, 7, "rw", "0x62000208");
    out.sub(2, 7, "rw", "0");
    out.several(0x1800, "TPDO", 9, 6);
    out.sub(0, 5, "ro", "6");
    out.sub(1, 7, "rw", "$NODEID+0x180");
    out.sub(2, 5, "rw", "1");
    out.sub(3, 6, "rw", "100");
    out.sub(5, 6, "rw", "10");
    out.sub(6, 5, "rw", "240");
    out.several(0x1A00, "TPDO 1 mapping", 9, 3);
    out.sub(0, 5, "rw", "2");
    out.sub(1, 7, "rw", "0x60000108");
    out.sub(2, 7, "rw", "0x60000208");
    out.several(0x6000, "Inputs", 8, 3);
    out.sub(0, 5, "ro", "2");
    out.sub(1, 5, "ro", "0", "PDOMapping=1\n");
    out.sub(2, 5, "rwr", "0", "PDOMapping=1\n");
    out.several(0x6200, "Outputs", 8, 3);
    out.sub(0, 5, "ro", "2");
    out.sub(1, 5, "rww", "0", "PDOMapping=1\n");
    out.sub(2, 5, "wo", "0", "PDOMapping=1\n");
}

void write_maker(Writer& out) {
    out.var(0x2000, "Trim", 3, "rw", "-5", "LowLimit=0xFF9C\nHighLimit=100\n");
    out.var(0x2001, "Name", 9, "rw", "hello");
    out.var(0x2002, "Program", 15, "rw", "", "");
    out.var(0x2003, "Gain", 8, "rw", "1.5", "LowLimit=0\nHighLimit=10.5\n");
    out.var(0x2004, "Switch", 1, "rw", "1");
    out.var(0x2005, "Key", 10, "rw", "01 20 7F");
    out.list(0x2006);
    out.raw(
        "[2006]\nParameterName=Table\nObjectType=0x8\nDataType=0x0005\nAccessType=rw\nDefaultValue=3\nPDOMapping=0\n"
        "CompactSubObj=3\n[2006Name]\nNrOfEntries=1\n2=Second\n[2006Value]\nNrOfEntries=1\n2=0x20\n");
}

struct Line {
    std::string text;
    bool touched{false};
    bool marked{false};
};

class Patcher {
  public:
    explicit Patcher(const std::string& text) {
        std::istringstream in{text};
        for (std::string line; std::getline(in, line);) {
            lines_.push_back({line, false, false});
        }
    }

    void apply(const std::string& patch) {
        if (patch.rfind("top ", 0) == 0) {
            lines_.insert(lines_.begin(), Line{patch.substr(4), true, false});
        } else if (patch.rfind("end ", 0) == 0) {
            lines_.push_back({patch.substr(4), true, false});
        } else if (patch == "@1") {
            lines_.front().marked = true;
        } else if (patch.front() == '@') {
            mark(patch.substr(1));
        } else if (patch.front() == '-') {
            remove_section(find(patch.substr(1)));
        } else {
            change(patch);
        }
    }

    PatchedSheet take() const {
        PatchedSheet out;
        const bool marked = std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.marked; });
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            out.text += lines_[i].text + "\n";
            if (marked ? lines_[i].marked : lines_[i].touched) {
                out.lines.push_back(static_cast<unsigned>(i + 1));
            }
        }
        return out;
    }

  private:
    /// Returns the line of the section; the number of lines when there is none.
    std::size_t find(const std::string& section) const {
        std::size_t at = 0;
        while (at < lines_.size() && lines_[at].text != section) {
            ++at;
        }
        return at;
    }
    std::size_t end_of(std::size_t section) const {
        std::size_t at = section + 1;
        while (at < lines_.size() && lines_[at].text.rfind('[', 0) != 0) {
            ++at;
        }
        return at;
    }
    /// Returns the line of the key; the end of the section when it has none.
    std::size_t key_in(std::size_t section, const std::string& key) const {
        std::size_t at = section + 1;
        while (at < end_of(section) && lines_[at].text.rfind(key + "=", 0) != 0) {
            ++at;
        }
        return at;
    }

    void mark(const std::string& words) {
        const auto blank = words.find("] ");
        const std::size_t section = find(words.substr(0, blank == std::string::npos ? blank : blank + 1));
        const std::size_t at = blank == std::string::npos ? section : key_in(section, words.substr(blank + 2));
        lines_.at(at).marked = true;
    }

    void remove_section(std::size_t section) {
        if (section >= lines_.size()) {
            throw std::out_of_range{"no such section"};
        }
        const auto begin = lines_.begin() + static_cast<std::ptrdiff_t>(section);
        lines_.erase(begin, lines_.begin() + static_cast<std::ptrdiff_t>(end_of(section)));
        lines_.front().touched = true;
    }

    void change(const std::string& patch) {
        const auto cut = patch.find("] ");
        const std::string name = patch.substr(0, cut + 1);
        const std::string words = patch.substr(cut + 2);
        std::size_t section = find(name);
        if (section == lines_.size()) {
            lines_.push_back({name, true, false});
        }
        if (words.front() == '~') {
            lines_[section] = Line{words.substr(1), true, false};
        } else if (words.front() == '+') {
            insert(end_of(section), words.substr(1));
        } else if (words.front() == '-') {
            const std::size_t at = key_in(section, words.substr(1));
            if (at == end_of(section)) {
                throw std::out_of_range{patch};
            }
            lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(at));
            lines_[section].touched = true;
        } else {
            set(section, words);
        }
    }

    void set(std::size_t section, const std::string& words) {
        const auto sign = words.find_first_of("=~");
        const std::size_t at = key_in(section, words.substr(0, sign));
        const std::string line = words[sign] == '~' ? words.substr(sign + 1) : words;
        if (at == end_of(section)) {
            insert(at, line);
        } else {
            lines_[at] = Line{line, true, false};
        }
    }

    void insert(std::size_t at, const std::string& line) {
        lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(at), Line{line, true, false});
    }

    std::vector<Line> lines_;
};

}  // namespace

namespace {

std::string written_sheet() {
    Writer out;
    out.raw(head);
    write_communication(out);
    write_pdos(out);
    write_maker(out);
    return out.text();
}

}  // namespace

const std::string& good_sheet() {
    static const std::string text = written_sheet();
    return text;
}

PatchedSheet patched_sheet(const std::string& patches) {
    Patcher patcher{good_sheet()};
    std::string rest = patches;
    while (!rest.empty()) {
        const std::string separator = " | ";
        const auto cut = rest.find(separator);
        patcher.apply(rest.substr(0, cut));
        rest = cut == std::string::npos ? "" : rest.substr(cut + separator.size());
    }
    return patcher.take();
}

}  // namespace canproof::host::test
