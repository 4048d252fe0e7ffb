#include "bench/contest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scanshade/image/png.hpp"

namespace scanshade::bench {
namespace {

constexpr RivalInfo all_rivals[] = {
    {our_name, make_ours}, {"llvmpipe", make_llvmpipe}, {"embree", make_embree}};

// Frames are timed in turns: some of one rival, some of the next, and again, so that what disturbs
// the machine disturbs all. The first frame of a turn finds the others' data in the caches.
constexpr int turns = 5, least_frames = 4, most_frames = 20;  // timed ones a turn
constexpr double turn_ms = 40;

/// A result and who gives it.
struct Entrant {
    RivalProcess* rival;
    std::size_t way;
    Result* result;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 != 0 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

void save(const Picture& picture, int width, const std::filesystem::path& path) {
    Image image(width, int(picture.rgba.size()) / width);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            image.rgb[3 * i + c] = std::uint8_t(picture.rgba[i] >> 8 * c);
    save_png(image, path);
}

std::string file_name(const Cell& cell, const Result& result) {
    std::string name = fmt::format("{}-{}-{}", name_of(cell), result.rival, result.way);
    std::replace(name.begin(), name.end(), '/', '-');
    return name + ".png";
}

/// Compares every picture with the first. `keep`: writes all of them, else those that disagree
/// and the first.
void check_pictures(const Cell& cell, const std::vector<Entrant>& entrants,
                    const std::filesystem::path& folder, bool keep) {
    std::vector<Picture> pictures;
    for (const Entrant& entrant : entrants) {
        pictures.push_back(entrant.rival->picture(entrant.way));
        entrant.result->copy_out_ms = pictures.back().copy_out_ms;
        entrant.result->agreement = compare(pictures[0], pictures.back(), cell.width);
    }
    const auto disagrees = [](const Entrant& e) { return !e.result->agreement.good(); };
    const bool any = std::any_of(entrants.begin(), entrants.end(), disagrees);
    for (std::size_t i = 0; i < entrants.size(); ++i)
        if (keep || disagrees(entrants[i]) || (i == 0 && any))
            save(pictures[i], cell.width, folder / file_name(cell, *entrants[i].result));
}

void time_frames(const std::vector<Entrant>& entrants) {
    std::vector<int> frames;
    for (const Entrant& entrant : entrants) {
        const double ms = entrant.rival->draw(entrant.way, 2, 1)[0];
        frames.push_back(
            std::clamp(int(std::ceil(turn_ms / std::max(ms, 0.01))), least_frames, most_frames));
    }
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < entrants.size(); ++i) {
            const auto ms = entrants[i].rival->draw(entrants[i].way, 1, frames[i]);
            std::vector<double>& all = entrants[i].result->ms;
            all.insert(all.end(), ms.begin(), ms.end());
        }
    for (const Entrant& entrant : entrants) {
        entrant.result->median_ms = median(entrant.result->ms);
        entrant.result->min_ms =
            *std::min_element(entrant.result->ms.begin(), entrant.result->ms.end());
    }
}

}  // namespace

Contest::Contest(Group group, std::filesystem::path folder, bool keep_pictures)
    : group_(std::move(group)), folder_(std::move(folder)), keep_pictures_(keep_pictures) {
    for (const RivalInfo& info : all_rivals)
        rivals_.push_back(std::make_unique<RivalProcess>(info, group_));
}

std::vector<std::string> Contest::about() {
    std::vector<std::string> lines;
    for (const auto& rival : rivals_)
        lines.push_back(fmt::format("{}: {}", rival->name(), rival->about()));
    return lines;
}

CellResult Contest::run(std::size_t number) {
    CellResult out{group_.cells[number], {}};
    std::vector<Entrant> entrants;
    for (const auto& rival : rivals_) {
        const std::vector<std::string> ways = rival->prepare(number);
        for (std::size_t way = 0; way < ways.size(); ++way) {
            Result result;
            result.rival = rival->name();
            result.way = ways[way];
            out.results.push_back(std::move(result));
            entrants.push_back({rival.get(), way, nullptr});
        }
    }
    for (std::size_t i = 0; i < entrants.size(); ++i) entrants[i].result = &out.results[i];

    check_pictures(out.cell, entrants, folder_, keep_pictures_);
    const bool agree = std::all_of(out.results.begin(), out.results.end(),
                                   [](const Result& r) { return r.agreement.good(); });
    if (agree) time_frames(entrants);
    for (const Entrant& entrant : entrants) entrant.result->memory = entrant.rival->memory();
    return out;
}

}  // namespace scanshade::bench
