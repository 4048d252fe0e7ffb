#include "scanshade/scene/obj.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

ObjFile load(const std::string& text) {
    const TempFolder folder;
    return load_obj(folder.write("a.obj", text));
}

/// What the file is refused with, without the folder: "a.obj:4: ...".
std::string refusal(const std::string& text) {
    try {
        load(text);
    } catch (const Error& error) {
        CHECK(error.code() == Errc::format);
        const std::string what = error.what();
        return what.substr(std::min(what.find("a.obj"), what.size()));
    }
    return "no error";
}

void check_refused(const std::string& text, const std::string& start) {
    CAPTURE(text.substr(0, 200));
    const std::string what = refusal(text);
    CAPTURE(what);
    CHECK(what.substr(0, start.size()) == start);
}

}  // namespace

TEST_CASE("faces keep their order, polygons and attributes", "[obj]") {
    const ObjFile file = load(
        "# a comment\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n"
        "vt 0.25 0.75\nvt 0.5\nvn 0 0 2\n"
        "f 1/1/1 2/2/1 3//1 4\nf 1 2 3 # behind a face\n");
    const PolygonSoup& soup = file.soup;
    CHECK(soup.name == "a");
    CHECK(soup.positions.size() == 4);
    CHECK(soup.positions[2] == glm::dvec3(1, 1, 0));
    REQUIRE(soup.texcoords.size() == 2);
    CHECK(soup.texcoords[0].y == Approx(0.75));
    CHECK(soup.texcoords[1] == glm::dvec2(0.5, 0));
    CHECK(soup.normals == std::vector<glm::dvec3>{{0, 0, 2}});
    CHECK(soup.face_begin == std::vector<std::uint32_t>{0, 4, 7});
    CHECK(soup.corners[1].texcoord == 1);
    CHECK(soup.corners[2].texcoord == no_index);
    CHECK(soup.corners[2].normal == 0);
    CHECK(soup.corners[3].normal == no_index);
    CHECK(soup.face_smoothing.empty());
    CHECK(soup.face_material == std::vector<std::uint32_t>{0, 0});
    CHECK(file.materials.size() == 1);
    CHECK(file.warnings.empty());
}

TEST_CASE("negative numbers count back from where they stand", "[obj]") {
    const ObjFile file = load(triangle + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
    const auto& c = file.soup.corners;
    CHECK(c[0].position == 0);
    CHECK(c[2].position == 2);
    CHECK(c[3].position == 0);
    CHECK(c[5].position == 3);
    check_refused(triangle + "f -4 -2 -1\n",
                  "a.obj:4: face refers to vertex -4, but the file has 3 so far;");
}

TEST_CASE("numbers that no element has are refused with their line", "[obj]") {
    check_refused(triangle + "f 1 2 3\nf 1 2 9\nf 1 2 10\n",
                  "a.obj:5: face refers to vertex 9, but the file has 3;");
    check_refused(triangle + "f 0 1 2\n", "a.obj:4: face refers to vertex 0,");
    check_refused(triangle + "f 1/1 2/1 3/1\n", "a.obj:4: face refers to texture vertex 1,");
    check_refused(triangle + "vn 0 0 1\nf 1//1 2//2 3//1\n",
                  "a.obj:5: face refers to vertex normal 2,");
    // 2^32 + 1 must not wrap to 1.
    check_refused(triangle + "f 4294967297 2 3\n", "a.obj:4: '4294967297' is not a corner");
    check_refused(triangle + "f 1 2 -99999999999999999999\n", "a.obj:4:");
    for (const char* word : {"a", "1.5", "1/2/3/4", "1-2", "/1", "+-1"})
        check_refused(triangle + "f 1 2 " + word + "\n", "a.obj:4: '");
}

TEST_CASE("a face may refer to what comes later in the file", "[obj]") {
    CHECK(load("f 1 2 3\n" + triangle).soup.face_count() == 1);
}

TEST_CASE("numbers that no double holds are refused with their line", "[obj]") {
    for (const char* number : {"1e400", "-1e99999999999", "nan", "inf", "-nan", "0x10", "1,5",
                               "abc", "1e", "--1", "+-1"}) {
        CAPTURE(number);
        for (const char* statement : {"v 0 0 ", "vn 1 0 ", "vt 0 "})
            check_refused(triangle + statement + number + "\n", "a.obj:4: '");
    }
    check_refused("v 1 2\n", "a.obj:1: 'v' has 2 numbers; it needs at least 3");
    check_refused("\n\nvt\n", "a.obj:3: 'vt' has 0 numbers");
    check_refused("v 1e200 0 0\n", "a.obj:1: the coordinate 1e+200 is too large");
}

TEST_CASE("numbers beyond float are read as they stand", "[obj]") {
    const ObjFile file = load("v 0 0 0\nv 1e39 0 0\nv 0 +1.E39 0\nv 1e-400 .5 -0.\nf 1 2 3\n");
    CHECK(file.soup.positions[1].x == Approx(1e39));
    CHECK(file.soup.positions[2].y == Approx(1e39));
    CHECK(file.soup.positions[3].x == Approx(0).margin(1e-300));
    const Mesh mesh = build_mesh(file.soup, {});
    REQUIRE(mesh.triangle_count() == 1);
    CHECK(mesh.face_normal[0] == std::array<float, 3>{0, 0, 1});
}

TEST_CASE("a concave polygon far from the origin keeps its area", "[obj]") {
    // An arrow of size 1 at a distance of 1e6: loaders with absolute tolerances drop it.
    const ObjFile file = load(
        "v 1000000 1000000 0\nv 1000002 1000000 0\nv 1000000.5 1000000.5 0\n"
        "v 1000000 1000002 0\nf 1 2 3 4\n");
    const Mesh mesh = build_mesh(file.soup, {});
    REQUIRE(mesh.triangle_count() == 2);
    CHECK(mesh.events[Event::concave_face] == 1);
    for (const auto& t : mesh.triangle)
        CHECK(std::count(t.begin(), t.end(), 2u) == 1);  // both contain the reflex corner
}

TEST_CASE("a polygon of more than 255 corners is one face", "[obj]") {
    std::string text, face = "f";
    for (int i = 0; i < 600; ++i) {
        const double a = 6.283185307179586 * i / 600;
        text += "v " + std::to_string(std::cos(a)) + " " + std::to_string(std::sin(a)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const ObjFile file = load(text + face);
    CHECK(file.soup.face_count() == 1);
    CHECK(build_mesh(file.soup, {}).triangle_count() == 598);
    std::string huge = triangle + "f";
    for (int i = 0; i < 70000; ++i) huge += " 1";
    check_refused(huge, "a.obj:4: face has 70000 corners; at most 65536 are read");
}

TEST_CASE("faces with too few corners are counted, not lost silently", "[obj]") {
    const ObjFile file = load(triangle + "f\nf 1 2\nf 1 2 3\n");
    CHECK(file.soup.face_count() == 3);
    const Mesh mesh = build_mesh(file.soup, {});
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.events[Event::degenerate_face] == 2);
}

TEST_CASE("every line ending, continued lines and a missing last one are read", "[obj]") {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        CAPTURE(end);
        const std::string text = "v 0 0 0" + end + "v 1 \\" + end + "0 0" + end + end +
                                 "\tv 0 1 0 " + end + "f 1 2 \\" + end + "3";
        const ObjFile file = load(text);
        CHECK(file.soup.positions.size() == 3);
        CHECK(file.soup.corners.size() == 3);
        check_refused(text + end + "f 1 2 4", "a.obj:8:");
    }
    CHECK(load("\xef\xbb\xbf" + triangle + "f 1 2 3").soup.positions.size() == 3);
    CHECK(load(triangle + "f 1 2 3\\").soup.corners.size() == 3);
}

TEST_CASE("files without faces load, files that are no text do not", "[obj]") {
    for (const std::string& text : {std::string(), std::string("\n"), std::string("hello\nworld"),
                                    triangle + "p 1 2 3\nl 1 2\n"}) {
        const ObjFile file = load(text);
        CHECK(file.soup.face_count() == 0);
        CHECK(file.materials.size() == 1);
    }
    check_refused(std::string("v 0 0 0\n\0\1\2", 11), "a.obj:2: the line has a byte of value 0");
    check_refused(std::string("\xff\xfev\0", 4), "a.obj: the file is UTF-16 text");
    check_refused(std::string("\xfe\xff\0v", 4), "a.obj: the file is UTF-16 text");
    for (const fs::path path : {"/nonexistent/a.obj", "/tmp"}) try {
            load_obj(path);
            FAIL("no error");
        } catch (const Error& error) {
            CHECK(error.code() == Errc::file);
        }
}

TEST_CASE("smoothing groups are there only where the file speaks of them", "[obj]") {
    const ObjFile file = load(triangle +
                              "f 1 2 3\ns 7\nf 1 2 3\ns off\nf 1 2 3\ns 2\nf 1 2 3\n"
                              "s 0\nf 1 2 3\n");
    CHECK(file.soup.face_smoothing == std::vector<std::uint32_t>{0, 7, 0, 2, 0});
    CHECK(load(triangle + "s off\nf 1 2 3\n").soup.face_smoothing.size() == 1);
}

TEST_CASE("random bytes and cut statements are refused or read, never worse", "[obj]") {
    unsigned state = 12345;  // the text itself is printed where a check fails
    const std::string alphabet = "vnftsgo 0123456789-+./eE\\#\n\r\tinfa";
    for (int round = 0; round < 300; ++round) {
        std::string text = triangle;
        for (int i = 0; i < 200; ++i) {
            state = state * 1664525u + 1013904223u;
            text += alphabet[(state >> 16) % alphabet.size()];
        }
        CAPTURE(round, text);
        try {
            const ObjFile file = load(text);
            for (const PolygonSoup::Corner& c : file.soup.corners)
                REQUIRE(c.position < file.soup.positions.size());
            build_mesh(file.soup, {});
        } catch (const Error& error) {
            CHECK(error.code() == Errc::format);
        }
    }
}

TEST_CASE("every OBJ file of the assimp models loads or is refused in one sentence", "[obj]") {
    const fs::path models = "/usr/share/assimp/models";
    if (!fs::exists(models)) {
        WARN("skipped: the package assimp-testmodels is not installed");
        return;
    }
    std::size_t loaded = 0, refused = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(models)) {
        if (entry.path().extension() != ".obj") continue;
        CAPTURE(entry.path().string());
        try {
            const ObjFile file = load_obj(entry.path());
            const Mesh mesh = build_mesh(file.soup, {});
            std::size_t triangles = 0;
            for (std::size_t f = 0; f < mesh.face_count(); ++f)
                triangles += mesh.corner_count(f) - 2;
            CHECK(mesh.triangle_count() == triangles);
            CHECK(mesh.face_count() + mesh.events[Event::degenerate_face] ==
                  file.soup.face_count());
            for (const std::uint32_t m : mesh.face_material) CHECK(m < file.materials.size());
            ++loaded;
        } catch (const Error& error) {
            const std::string what = error.what();
            CAPTURE(what);
            CHECK(error.code() == Errc::format);
            CHECK(what.find('\n') == std::string::npos);
            CHECK(what.find(entry.path().string()) == 0);
            ++refused;
        }
    }
    CHECK(loaded >= 20);
    CHECK(refused == 3);  // UTF-16, a face with vertex 0, "3.1+e2" for a number
}
