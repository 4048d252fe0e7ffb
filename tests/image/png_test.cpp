#include "scanshade/image/png.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scanshade/base/error.hpp"
#include "support/catch.hpp"

using namespace scanshade;
namespace fs = std::filesystem;

namespace {

/// An empty folder that goes away with its object.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("scanshade-png-" + std::to_string(::getpid()));
    Folder() { fs::create_directory(path); }
    ~Folder() { fs::remove_all(path); }
    std::size_t count() const {
        return std::size_t(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

Image gradient(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.pixel(x, y)[0] = std::uint8_t(x);
            image.pixel(x, y)[1] = std::uint8_t(y);
            image.pixel(x, y)[2] = std::uint8_t(x ^ y);
        }
    return image;
}

void check_error(Errc code, const std::string& part, const std::function<void()>& call) {
    try {
        call();
        FAIL("no error, expected: " << part);
    } catch (const Error& error) {
        CAPTURE(error.what());
        CHECK(error.code() == code);
        CHECK(std::string(error.what()).find(part) != std::string::npos);
    }
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("a picture comes back from its file as it was", "[image][png]") {
    const Folder folder;
    const fs::path file = folder.path / "a.png";
    const Image image = gradient(37, 23);
    save_png(image, file);
    const Image back = load_image(file);
    CHECK(back.width == 37);
    CHECK(back.height == 23);
    CHECK(back.rgb == image.rgb);
    save_png(gradient(2, 2), file);  // replaces
    CHECK(load_image(file).width == 2);
    CHECK(folder.count() == 1);  // no temporary file stays
}

TEST_CASE("writing through a link keeps the link", "[image][png]") {
    const Folder folder;
    save_png(gradient(3, 3), folder.path / "real.png");
    fs::create_symlink("real.png", folder.path / "link.png");
    save_png(gradient(5, 5), folder.path / "link.png");
    CHECK(fs::is_symlink(folder.path / "link.png"));
    CHECK(load_image(folder.path / "real.png").width == 5);
}

TEST_CASE("a picture that cannot be written is an error that says why", "[image][png]") {
    const Folder folder;
    const Image image = gradient(4, 4);
    check_error(Errc::file, "No such file or directory",
                [&] { save_png(image, folder.path / "none" / "a.png"); });
    check_error(Errc::file, "Is a directory", [&] { save_png(image, folder.path); });
    if (fs::exists("/dev/full")) {
        check_error(Errc::file, "No space left on device", [&] { save_png(image, "/dev/full"); });
        CHECK(fs::exists("/dev/full"));
    }
    CHECK(folder.count() == 0);
}

TEST_CASE("sizes that no PNG writer should see are refused first", "[image][png]") {
    Image image;
    check_error(Errc::usage, "0 × 0", [&] { encode_png(image); });
    image.width = max_image_side + 1;
    image.height = 1;
    check_error(Errc::usage, "16384", [&] { encode_png(image); });
    image.width = -1;
    check_error(Errc::usage, "-1", [&] { encode_png(image); });
}

TEST_CASE("files that are no pictures are refused by name", "[image][png]") {
    const Folder folder;
    check_error(Errc::file, "none.png", [&] { load_image(folder.path / "none.png"); });
    check_error(Errc::file, "directory", [&] { load_image(folder.path); });
    for (const std::string& bytes : {std::string(), std::string("not a picture"),
                                     std::string("\x89PNG\r\n\x1a\n"), std::string(4096, '\xff')}) {
        write(folder.path / "bad.png", bytes);
        check_error(Errc::format, "bad.png", [&] { load_image(folder.path / "bad.png"); });
    }
    // Cut off at every length: an error or, within the last bytes, a picture; never a crash.
    const auto png = encode_png(gradient(16, 16));
    for (std::size_t length = 0; length < png.size(); length += 7) {
        write(folder.path / "cut.png", std::string(png.begin(), png.begin() + long(length)));
        try {
            CHECK(load_image(folder.path / "cut.png").width == 16);
        } catch (const Error& error) {
            CHECK(error.code() == Errc::format);
        }
    }
}

TEST_CASE("a header that claims too large a picture is refused before decoding", "[image][png]") {
    const Folder folder;
    auto png = encode_png(gradient(1, 1));
    png[16] = 0x00, png[17] = 0x01;  // IHDR: width 65537
    write(folder.path / "wide.png", std::string(png.begin(), png.end()));
    check_error(Errc::format, "wide.png", [&] { load_image(folder.path / "wide.png"); });
}

TEST_CASE("grey is spread and alpha dropped", "[image][png]") {
    const Folder folder;
    write(folder.path / "grey.pgm", std::string("P5 2 1 255\n") + "\x10\xf0");
    CHECK(load_image(folder.path / "grey.pgm").rgb ==
          std::vector<std::uint8_t>{16, 16, 16, 240, 240, 240});
    write(folder.path / "deep.pgm", std::string("P5 1 1 65535\n") + "\x7f\xff");
    CHECK(load_image(folder.path / "deep.pgm").rgb == std::vector<std::uint8_t>{127, 127, 127});
}
