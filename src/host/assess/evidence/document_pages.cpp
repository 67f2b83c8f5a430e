// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/document_pages.hpp"

#include <fmt/format.h>

#include "host/assess/documents/device_documents.hpp"
#include "host/assess/documents/document.hpp"
#include "host/assess/documents/render.hpp"
#include "host/assess/documents/residual_errors.hpp"
#include "host/assess/evidence/item_links.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

constexpr const char* list_page = "documents.html";

class DocumentWriter {
  public:
    DocumentWriter(const PackInput& input, const PageFrame& frame)
        : input_{input}, frame_{frame}, links_{links_of(input)} {}

    std::map<std::string, std::string> write() {
        for (const auto& audit : input_.audits) {
            if (audit.part->is_device()) {
                list_ += fmt::format("<h2>{}</h2>\n", escaped(audit.part->info.title));
                add_all(audit.part->name, device_documents(*input_.content, *audit.part, input_.analysis));
            }
        }
        list_ += "<h2>All devices</h2>\n";
        add_all("all", {residual_errors(*input_.content, input_.analysis)});
        files_[list_page] =
            html_page("Documents", list_page, frame_,
                      "<p>These documents are generated from the requirements register and from reports/analysis. A "
                      "cell contains <code>missing</code> where neither has data.</p>\n" +
                          list_);
        return std::move(files_);
    }

  private:
    void add_all(const std::string& part, const std::vector<Document>& documents) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& document : documents) {
            const std::string page = fmt::format("{}-{}.html", part, document.name);
            const std::string file = fmt::format("documents/{}/{}", part, document.name);
            files_[page] = html_page(document.title, list_page, frame_, document_html(document, links_));
            files_[file + ".md"] = document_markdown(document);
            files_[file + ".json"] = document_json(document);
            rows.push_back(
                {fmt::format("<a href=\"{}\">{}</a>", escaped(page), escaped(document.title)), prose(document.about),
                 std::to_string(count_missing(document)),
                 fmt::format("<a href=\"{0}.md\">Markdown</a> <a href=\"{0}.json\">JSON</a>", escaped(file))});
        }
        list_ += html_table("Documents: " + part,
                            {{"Document", 28}, {"About"}, {"Missing cells", 10}, {"As a file", 14}}, rows);
    }

    const PackInput& input_;
    const PageFrame& frame_;
    ItemLinks links_;
    std::map<std::string, std::string> files_;
    std::string list_;
};

}  // namespace

std::map<std::string, std::string> document_files(const PackInput& input, const PageFrame& frame) {
    return DocumentWriter{input, frame}.write();
}

}  // namespace canproof::host
