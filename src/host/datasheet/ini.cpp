// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/ini.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/trimmed.hpp"

namespace canproof::host {

namespace {

bool has_control(std::string_view text) {
    return std::any_of(text.begin(), text.end(), [](char c) {
        const auto u = static_cast<unsigned char>(c);
        return u < 0x20U && c != '\t';
    });
}

class IniReader {
  public:
    explicit IniReader(const EdsTelling& tell) : tell_{tell} {}

    void read_line(std::string_view raw) {
        ++line_;
        if (raw.size() > longest_ini_line) {
            strange(fmt::format("line has more than {} characters", longest_ini_line));
            return;
        }
        const std::string_view text = trimmed_view(raw, ini_blanks);
        if (text.empty() || text.front() == ';' || text.front() == '#') {
            return;
        }
        if (has_control(text)) {
            strange("line contains control characters");
        } else if (text.front() == '[') {
            open_section(text);
        } else {
            add_value(text);
        }
    }
    bool is_strange() const { return strange_ > most_strange_lines; }
    IniFile take() { return std::move(file_); }

  private:
    void strange(std::string what) {
        ++strange_;
        tell_.note(line_, std::move(what), "it is ignored");
    }

    void open_section(std::string_view text) {
        const auto close = text.find(']');
        const std::string_view name =
            close == std::string_view::npos ? "" : trimmed_view(text.substr(1, close - 1), ini_blanks);
        if (name.empty()) {
            ++strange_;
            tell_.note(line_, fmt::format("`{}` is no section", text.substr(0, 40)), "it is ignored with its lines");
            section_ = nullptr;
            skips_ = true;
            return;
        }
        const std::string_view rest = trimmed_view(text.substr(close + 1), ini_blanks);
        if (!rest.empty() && rest.front() != ';' && rest.front() != '#') {
            tell_.note(line_, fmt::format("`{}` follows the section", rest.substr(0, 40)), "it is ignored");
        }
        const auto [place, is_new] =
            file_.sections.try_emplace(lower_case(name), IniSection{std::string{name}, line_, {}});
        if (!is_new) {
            tell_.note(line_, fmt::format("section [{}] is already in line {}", name, place->second.line),
                       "both are combined");
        }
        skips_ = false;
        section_ = &place->second;
    }

    void add_value(std::string_view text) {
        const auto equals = text.find('=');
        const std::string_view key = trimmed_view(text.substr(0, equals), ini_blanks);
        if (skips_) {
            return;  // the section itself has been reported already
        }
        if (equals == std::string_view::npos || key.empty()) {
            strange(fmt::format("`{}` is neither [Section] nor Key=Value", text.substr(0, 40)));
        } else if (section_ == nullptr) {
            strange(fmt::format("{} is before the first section", key));
        } else {
            const auto [place, is_new] = section_->values.try_emplace(
                lower_case(key), IniValue{std::string{trimmed_view(text.substr(equals + 1), ini_blanks)}, line_});
            if (!is_new) {
                tell_.note(line_, fmt::format("{} is already in line {}", key, place->second.line), "the first counts");
            }
        }
    }

    const EdsTelling& tell_;
    IniFile file_;
    IniSection* section_{nullptr};
    bool skips_{false};  ///< inside an invalid section
    std::size_t strange_{0};
    unsigned line_{0};
};

}  // namespace

std::string lower_case(std::string_view text) {
    std::string out{text};
    for (char& c : out) {
        c = lower_case(c);
    }
    return out;
}

const IniValue* IniSection::find(std::string_view key) const {
    const auto found = values.find(lower_case(key));
    return found == values.end() ? nullptr : &found->second;
}

const IniValue* IniSection::filled(std::string_view key) const {
    const IniValue* found = find(key);
    return found == nullptr || found->text.empty() ? nullptr : found;
}

const IniSection* IniFile::find(std::string_view name) const {
    const auto found = sections.find(lower_case(name));
    return found == sections.end() ? nullptr : &found->second;
}

IniFile read_ini(const std::string& text, const EdsTelling& tell) {
    IniReader reader{tell};
    const bool marked = text.rfind("\xEF\xBB\xBF", 0) == 0;  // UTF-8 byte order mark
    for (std::size_t at = marked ? 3 : 0; at < text.size() && !reader.is_strange();) {
        const auto end = std::min(text.find('\n', at), text.size());
        reader.read_line(std::string_view{text}.substr(at, end - at));
        at = end + 1;
    }
    if (reader.is_strange()) {
        tell.fault(1, fmt::format("more than {} lines are neither [Section] nor Key=Value", most_strange_lines),
                   "name an EDS, DCF or XDD file");
        return {};
    }
    return reader.take();
}

}  // namespace canproof::host
