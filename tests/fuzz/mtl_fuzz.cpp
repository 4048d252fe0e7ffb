// Material libraries, as a file with faces of each material uses them.
#include "fuzz/fuzz.hpp"
#include "scanshade/image/png.hpp"

using namespace scanshade;

namespace {

struct Workshop {
    TempFolder folder;
    std::filesystem::path obj;

    Workshop() {
        std::string text = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
        for (const char* name : {"a", "b", "c", ""})
            text += std::string("usemtl ") + name + "\nf 1/1 2/2 3/3\n";
        obj = folder.write("a.obj", text);
        save_png(Image(2, 2), folder.path / "t.png");
    }
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Workshop workshop;
    workshop.folder.write("m.mtl", std::string(text_of(data, size)));
    load_and_draw(workshop.obj);
    return 0;
}
