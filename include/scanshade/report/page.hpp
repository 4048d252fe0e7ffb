// A report as people read it: one HTML file that opens from disk, on a phone and on paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scanshade/report/provenance.hpp"

namespace scanshade {

/// Text for elements and attributes: what HTML would take for more is escaped.
std::string escaped(std::string_view text);

/// A cell of a table.
struct Cell {
    std::string text;
    std::string_view style = {};  // "good", "bad", "faint", "code" or "whole" (no line breaks)
    std::string file = {};        // beside the page, or "#anchor": the text leads there
};
Cell number_cell(std::string text, std::string_view style = {});

/// A picture and what it shows.
struct Figure {
    std::string file, caption;
    bool wide = false;  // keeps its size on a phone, and is moved there instead of shrunk
    int width = 0;      // pixels; 0: its own
};

class Page {
public:
    /// `lead` says in a sentence or two what the report is about.
    Page(std::string_view title, std::string_view lead);
    /// A part of a page, for append().
    Page() = default;

    /// What the report comes to, before anything else. `good`: nothing has failed.
    void verdict(std::string_view text, bool good = true);
    /// Stands out: something that a reader must know first.
    void notice(std::string_view text);
    /// `anchor`: what "#anchor" leads to; such a section begins a new sheet of paper.
    void section(std::string_view title, std::string_view anchor = {});
    void subsection(std::string_view title);
    void lead(std::string_view text);
    void paragraph(std::string_view text);
    /// Lines to type.
    void commands(const std::vector<std::string>& lines);
    /// A question whose answer is hidden until it is asked for, but on paper.
    void answer(std::string_view question, std::string_view text);
    /// Pictures that lie beside the page, next to each other where there is room.
    void figures(const std::vector<Figure>& figures);
    void table(const std::vector<std::string>& head, const std::vector<std::vector<Cell>>& rows);
    /// A list of files that lie beside the page, and where the numbers come from.
    void sources(const Provenance& provenance, const std::vector<std::string>& files);

    /// Another page's content goes on here, without its title.
    void append(const Page& part) { body_ += part.body_; }

    /// The whole page.
    std::string text() const;

private:
    std::string title_, body_;
};

}  // namespace scanshade
