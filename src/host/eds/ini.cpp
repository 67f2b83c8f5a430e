#include "host/eds/ini.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace canproof::host {

namespace {

std::string trimmed(const std::string& text) {
    const char* const blanks = " \t\r\v\f";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool has_control(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        const auto u = static_cast<unsigned char>(c);
        return u < 0x20U && c != '\t';
    });
}

class IniReader {
  public:
    IniReader(const std::string& name, Faults& faults) : name_{name}, faults_{faults} {}

    void read_line(const std::string& raw) {
        ++line_;
        if (raw.size() > longest_ini_line) {
            fault("line is too long", fmt::format("keep lines below {} characters", longest_ini_line));
            return;
        }
        const std::string text = trimmed(raw);
        if (text.empty() || text.front() == ';') {
            return;
        }
        if (has_control(text)) {
            fault("line holds control characters", "save the file as plain text");
        } else if (text.front() == '[') {
            open_section(text);
        } else {
            add_value(text);
        }
    }
    IniFile take() { return std::move(file_); }

  private:
    void fault(std::string what, std::string mend) {
        faults_.emplace_back(Place{name_, line_}, std::move(what), std::move(mend));
    }

    void open_section(const std::string& text) {
        section_ = nullptr;
        const std::string name = text.back() == ']' ? trimmed(text.substr(1, text.size() - 2)) : "";
        if (name.empty()) {
            fault(fmt::format("`{}` is no section", text.substr(0, 40)), "write [Name]");
            skips_ = true;
            return;
        }
        IniSection section;
        section.name = name;
        section.line = line_;
        const auto [place, is_new] = file_.sections.emplace(lower_case(name), section);
        if (!is_new) {
            fault(fmt::format("section [{}] stands already in line {}", name, place->second.line),
                  "keep one of the two");
        }
        skips_ = !is_new;
        section_ = is_new ? &place->second : nullptr;
    }

    void add_value(const std::string& text) {
        const auto equals = text.find('=');
        const std::string key = trimmed(text.substr(0, equals));
        if (equals == std::string::npos || key.empty()) {
            fault(fmt::format("`{}` is neither [Section] nor Key=Value", text.substr(0, 40)),
                  "write Key=Value, or ; before a comment");
        } else if (section_ == nullptr) {
            if (!skips_) {
                fault(fmt::format("{} stands before the first section", key),
                      "begin with a section such as [FileInfo]");
            }
        } else {
            const auto [place, is_new] =
                section_->values.emplace(lower_case(key), IniValue{trimmed(text.substr(equals + 1)), line_});
            if (!is_new) {
                fault(fmt::format("{} stands already in line {}", key, place->second.line), "keep one of the two");
            }
        }
    }

    const std::string& name_;
    Faults& faults_;
    IniFile file_;
    IniSection* section_{nullptr};
    bool skips_{false};  ///< in a section that was refused: told once
    unsigned line_{0};
};

}  // namespace

std::string lower_case(const std::string& text) {
    std::string out = text;
    std::transform(out.begin(), out.end(), out.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return out;
}

const IniValue* IniSection::find(const std::string& key) const {
    const auto found = values.find(lower_case(key));
    return found == values.end() ? nullptr : &found->second;
}

const IniValue* IniSection::filled(const std::string& key) const {
    const IniValue* found = find(key);
    return found == nullptr || found->text.empty() ? nullptr : found;
}

const IniSection* IniFile::find(const std::string& name) const {
    const auto found = sections.find(lower_case(name));
    return found == sections.end() ? nullptr : &found->second;
}

IniFile read_ini(const std::string& text, const std::string& name, Faults& faults) {
    if (text.size() > longest_ini_file) {
        faults.emplace_back(Place{name, 1}, fmt::format("file has {} bytes", text.size()),
                            fmt::format("an EDS has at most {}", longest_ini_file));
        return {};
    }
    IniReader reader{name, faults};
    const bool marked = text.rfind("\xEF\xBB\xBF", 0) == 0;  // UTF-8 byte order mark
    for (std::size_t at = marked ? 3 : 0; at < text.size() && faults.size() < most_ini_faults;) {
        const auto end = std::min(text.find('\n', at), text.size());
        reader.read_line(text.substr(at, end - at));
        at = end + 1;
    }
    return reader.take();
}

}  // namespace canproof::host
