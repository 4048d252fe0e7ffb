#include "scanshade/report/page.hpp"

#include <fmt/format.h>

#include "scanshade/report/document.hpp"

namespace scanshade {
namespace {

constexpr std::string_view css = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #22262c; background: #fff;
       max-width: 68rem; margin: 0 auto; padding: 1rem; overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0; }
h2 { font-size: 1.25rem; margin: 2rem 0 .5rem; border-bottom: 1px solid #d5d8dc; }
h3 { font-size: 1.05rem; margin: 1.5rem 0 .3rem; }
.lead { font-size: 1.1rem; color: #444a52; }
.notice { border-left: 4px solid #b3541e; background: #fdf3ec; padding: .5rem 1rem; }
.verdict { border-left: 4px solid #0b6b3a; background: #eef7f1; padding: .5rem 1rem; }
.failed { border-color: #a32012; background: #fdeeec; }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
figure { margin: 0; max-width: 100%; overflow-x: auto; break-inside: avoid; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { font-size: .9rem; color: #555c66; max-width: 32rem; }
pre { background: #f4f5f7; padding: .6rem .8rem; font-size: .85rem; overflow-x: auto; }
.code { font-family: ui-monospace, monospace; }
details { margin: .5rem 0; }
summary { cursor: pointer; font-weight: 600; }
details p { margin: .2rem 0 .2rem 1.1rem; }
.scroll { overflow-x: auto; margin: 0 0 1rem; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; padding: .2rem .6rem; border-bottom: 1px solid #e3e5e8;
         vertical-align: top; }
th { background: #f4f5f7; }
tr { break-inside: avoid; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.whole { white-space: nowrap; }
.good { color: #0b6b3a; font-weight: 600; }
.bad { color: #a32012; font-weight: 600; }
.faint { color: #737a84; }
@media (max-width: 40rem) { body { font-size: 15px; padding: .7rem; }
                            .wide img { max-width: none; } }
@media print { body { max-width: none; font-size: 10pt; } .scroll, figure { overflow: visible; }
               details::details-content { content-visibility: visible; display: block; }
               h2[id] { break-before: page; } h2, h3 { break-after: avoid; }
               pre { white-space: pre-wrap; font-size: 8pt; break-inside: avoid; }
               .lead { font-size: 11pt; } figcaption { font-size: 8pt; }
               figure[style] { max-width: 4.2cm; } figure.wide[style] { max-width: 8.6cm; }
               table { font-size: 8pt; } th, td { padding: .1rem .3rem; } }
)";

std::string element(std::string_view name, std::string_view style, std::string_view text) {
    const std::string attribute = style.empty() ? "" : fmt::format(" class=\"{}\"", style);
    return fmt::format("<{}{}>{}</{}>", name, attribute, escaped(text), name);
}

std::string table_cell(const Cell& cell) {
    if (cell.file.empty()) return element("td", cell.style, cell.text);
    return fmt::format("<td class=\"{}\"><a href=\"{}\">{}</a></td>", cell.style,
                       escaped(cell.file), escaped(cell.text));
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : clean_text(text)) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    return out;
}

Cell number_cell(std::string text, std::string_view style) {
    constexpr std::pair<std::string_view, std::string_view> styles[] = {
        {"good", "good number"}, {"bad", "bad number"}, {"faint", "faint number"}};
    for (const auto& [name, with_number] : styles)
        if (name == style) return {std::move(text), with_number};
    return {std::move(text), "number"};
}

Page::Page(std::string_view title, std::string_view lead)
    : title_(title), body_(element("h1", "", title) + "\n") {
    this->lead(lead);
}

void Page::verdict(std::string_view text, bool good) {
    body_ += element("p", good ? "verdict" : "verdict failed", text) + "\n";
}
void Page::notice(std::string_view text) { body_ += element("p", "notice", text) + "\n"; }
void Page::section(std::string_view title, std::string_view anchor) {
    body_ += anchor.empty()
                 ? element("h2", "", title) + "\n"
                 : fmt::format("<h2 id=\"{}\">{}</h2>\n", escaped(anchor), escaped(title));
}
void Page::subsection(std::string_view title) { body_ += element("h3", "", title) + "\n"; }
void Page::lead(std::string_view text) { body_ += element("p", "lead", text) + "\n"; }
void Page::paragraph(std::string_view text) { body_ += element("p", "", text) + "\n"; }

void Page::commands(const std::vector<std::string>& lines) {
    body_ += "<pre>";
    for (const std::string& line : lines) body_ += escaped(line) + "\n";
    body_ += "</pre>\n";
}

void Page::answer(std::string_view question, std::string_view text) {
    body_ +=
        "<details>" + element("summary", "", question) + element("p", "", text) + "</details>\n";
}

void Page::figures(const std::vector<Figure>& figures) {
    body_ += "<div class=\"figures\">\n";
    for (const auto& [file, caption, wide, width] : figures)
        body_ += fmt::format("<figure{}{}><img src=\"{}\"{} alt=\"{}\">{}</figure>\n",
                             wide ? " class=\"wide\"" : "",
                             width > 0 ? fmt::format(" style=\"width:{}px\"", width) : "",
                             escaped(file), width > 0 ? fmt::format(" width=\"{}\"", width) : "",
                             escaped(caption), element("figcaption", "", caption));
    body_ += "</div>\n";
}

void Page::table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows) {
    body_ += "<div class=\"scroll\"><table>\n<thead><tr>";
    for (const std::string& name : head) body_ += element("th", "", name);
    body_ += "</tr></thead>\n<tbody>\n";
    for (const std::vector<Cell>& row : rows) {
        body_ += "<tr>";
        for (const Cell& cell : row) body_ += table_cell(cell);
        body_ += "</tr>\n";
    }
    body_ += "</tbody></table></div>\n";
}

void Page::sources(const Provenance& p, const std::vector<std::string>& files) {
    section("Where the numbers come from");
    table({"what", ""}, {{{"commit"}, {p.commit}},
                         {{"compiler"}, {p.compiler}},
                         {{"flags"}, {p.flags}},
                         {{"processor"}, {p.cpu}},
                         {{"instruction set"}, {p.isa}},
                         {{"threads"}, {fmt::format("{}", p.threads)}},
                         {{"seed of the order of runs"}, {fmt::format("{}", p.seed)}},
                         {{"date"}, {p.date}}});
    body_ += "<p>The same numbers for programs:";
    for (const std::string& file : files)
        body_ += fmt::format(" <a href=\"{0}\">{0}</a>", escaped(file));
    body_ += "</p>\n";
}

std::string Page::text() const {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        escaped(title_), css, body_);
}

}  // namespace scanshade
