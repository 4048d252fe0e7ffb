// The files around the one that is shown.
#include "viewer/files.hpp"

#include "scanshade/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace scanshade;
using namespace scanshade::viewer;

TEST_CASE("saved pictures take the first free number", "[viewer]") {
    const TempFolder folder;
    const auto next = [&](const char* model) { return next_free_path(folder.path, model, "png"); };
    CHECK(next("ball") == folder.path / "ball_1.png");
    folder.write("ball_1.png", "");
    folder.write("ball_3.png", "");
    CHECK(next("ball") == folder.path / "ball_2.png");
    folder.write("ball_2.png", "");
    CHECK(next("ball") == folder.path / "ball_4.png");
    CHECK(next("cube") == folder.path / "cube_1.png");
    CHECK(next_free_path(folder.path, "ball", "toml") == folder.path / "ball_1.toml");
}

TEST_CASE("neighbours are the scenes and meshes of the folder, around its end", "[viewer]") {
    const TempFolder folder;
    for (const char* name : {"b.obj", "a.toml", "c.png", "d.toml"}) folder.write(name, "");
    const auto from = [&](const char* name, int step) {
        return neighbour(folder.path / name, step).filename().string();
    };
    CHECK(from("a.toml", 1) == "b.obj");
    CHECK(from("b.obj", 1) == "d.toml");
    CHECK(from("d.toml", 1) == "a.toml");
    CHECK(from("a.toml", -1) == "d.toml");
    CHECK(from("a.toml", -4) == "d.toml");
    CHECK(from("gone.obj", 1) == "gone.obj");
}

TEST_CASE("a change of a scene or its meshes is noticed once it has settled", "[viewer]") {
    const TempFolder folder;
    const auto scene_file = folder.write("s.toml", "one");
    Scene scene;
    scene.objects.emplace_back();
    scene.objects[0].mesh_file = folder.write("m.obj", "one");
    FileWatch watch;
    watch.watch(scene_file, scene);
    CHECK_FALSE(watch.changed());
    for (const char* name : {"s.toml", "m.obj"}) {
        folder.write(name, std::string("longer ") + name);
        CHECK_FALSE(watch.changed());  // may still be written
        CHECK(watch.changed());
        CHECK_FALSE(watch.changed());
    }
    std::filesystem::remove(scene.objects[0].mesh_file);
    CHECK_FALSE(watch.changed());
    CHECK(watch.changed());
}
