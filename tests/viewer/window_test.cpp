// The viewer from outside: a real window on a virtual display, real mouse and keys, screenshots.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <sstream>
#include <thread>

#include "cli/process.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/image/png.hpp"
#include "support/catch.hpp"

using namespace scanshade;

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto patience = std::chrono::seconds(5);

/// Asks until the answer is yes or patience ends.
template <class Answer>
bool wait_until(Answer answer) {
    const auto end = Clock::now() + patience;
    while (!answer()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

/// A program in the background; killed where it still runs at the end.
class Background {
public:
    /// Standard error goes to the file `err`. `kept_open` stays open in the program.
    Background(const std::vector<std::string>& command, const std::string& folder,
               const std::string& err, int kept_open = -1) {
        std::vector<char*> argv;
        for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
        child_ = ::fork();
        if (child_ != 0) return;
        if (kept_open >= 0) ::fcntl(kept_open, F_SETFD, 0);
        const int file = ::open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        ::dup2(file, STDOUT_FILENO);
        ::dup2(file, STDERR_FILENO);
        if (::chdir(folder.c_str()) == 0) ::execvp(argv[0], argv.data());
        ::_exit(127);
    }
    ~Background() {
        if (status()) return;
        ::kill(child_, SIGTERM);
        if (!wait_until([&] { return status().has_value(); })) ::kill(child_, SIGKILL);
    }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// The exit status, once it has ended.
    std::optional<int> status() {
        int how = 0;
        if (!status_ && ::waitpid(child_, &how, WNOHANG) == child_)
            status_ = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
        return status_;
    }

    /// Processor time so far, in clock ticks.
    long ticks() const {
        const std::string stat = read_file("/proc/" + std::to_string(child_) + "/stat");
        std::istringstream fields(stat.substr(stat.rfind(')') + 2));
        std::string skipped;
        for (int i = 0; i < 11; ++i) fields >> skipped;
        long user = 0, system = 0;
        fields >> user >> system;
        return user + system;
    }

private:
    pid_t child_ = -1;
    std::optional<int> status_;
};

/// What a shell command prints.
std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    char buffer[4096];
    for (std::size_t n; (n = ::fread(buffer, 1, sizeof buffer, pipe)) > 0;) text.append(buffer, n);
    ::pclose(pipe);
    return text;
}

bool all_installed() {
    for (const char* program : {"Xvfb", "xdotool", "import"})
        if (output_of(std::string("command -v ") + program).empty()) {
            WARN("skipped: " << program << " is not installed");
            return false;
        }
    return true;
}

/// A virtual display of its own; DISPLAY names it for as long as it lives.
class Display {
public:
    explicit Display(const TempFolder& folder) {
        REQUIRE(::pipe2(ends_, O_CLOEXEC) == 0);
        server_.emplace(
            std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends_[1]), "-screen", "0",
                                     "640x480x24", "-nolisten", "tcp", "-noreset"},
            folder.path, folder.path / "xvfb.log", ends_[1]);
        ::close(ends_[1]);
        pollfd ready{ends_[0], POLLIN, 0};
        char number[16] = {};
        REQUIRE(::poll(&ready, 1, 5000) == 1);
        REQUIRE(::read(ends_[0], number, sizeof number - 1) > 0);
        ::setenv("DISPLAY", (":" + std::to_string(std::atoi(number))).c_str(), 1);
    }
    ~Display() {
        if (before_)
            ::setenv("DISPLAY", before_->c_str(), 1);
        else
            ::unsetenv("DISPLAY");
        ::close(ends_[0]);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

private:
    std::optional<std::string> before_ =
        ::getenv("DISPLAY") ? std::optional<std::string>(::getenv("DISPLAY")) : std::nullopt;
    int ends_[2] = {-1, -1};
    std::optional<Background> server_;
};

/// The viewer's window as a person meets it.
class Person {
public:
    explicit Person(const TempFolder& folder) : folder_(folder) {
        REQUIRE(wait_until([&] {
            window_ = output_of("xdotool search --onlyvisible --name '^ball [|]' 2>/dev/null");
            return !window_.empty();
        }));
        window_.pop_back();
        act("windowfocus " + window_);
    }

    void act(const std::string& what) const { output_of("xdotool " + what); }
    void press(const std::string& key) const { act("key " + key); }
    void move(int x, int y, const std::string& then = {}) const {
        act("mousemove --window " + window_ + " " + std::to_string(x) + " " + std::to_string(y) +
            " " + then);
    }
    void resize(int width, int height) const {
        act("windowsize " + window_ + " " + std::to_string(width) + " " + std::to_string(height));
    }

    /// What the window shows now; empty where it is just changing its size.
    Image look() const {
        const std::string path = folder_.path / "screen.png";
        output_of("import -window " + window_ + " '" + path + "' 2>&1");
        try {
            return load_image(path);
        } catch (const Error&) {
            return {};
        }
    }

    /// Whether the window comes to show this picture, to a rounding of one in a byte.
    bool sees(const Image& expected) const {
        return wait_until([&] {
            const Image seen = look();
            return seen.width == expected.width && seen.height == expected.height &&
                   diff(seen, expected).max_delta <= 1;
        });
    }

    /// Whether the window comes to show another picture of the same size.
    bool sees_other_than(const Image& old) const {
        return wait_until([&] {
            const Image seen = look();
            return seen.width == old.width && seen.height == old.height &&
                   diff(seen, old).count > 100;
        });
    }

private:
    const TempFolder& folder_;
    std::string window_;
};

Image rendered(const TempFolder& folder, const std::string& scene, const std::string& resolution,
               std::vector<std::string> options = {}) {
    const std::string path = folder.path / "rendered.png";
    options.insert(options.begin(), {"render", scene, "-o", path, "--resolution", resolution});
    const Finished run = run_scanshade(options);
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    return load_image(path);
}

const std::string viewer = std::filesystem::path(SCANSHADE_BINARY).parent_path() / "scanshade-view";

/// Lit from the side so that every orbit shows; one texture-less sphere coarse enough to tell flat
/// from gouraud and perspective from edges.
constexpr const char* ball = R"(
[[light]]
type = "directional"
direction = [-1, -0.5, 0]
[[object]]
shape = "sphere"
tessellation = 3
)";

}  // namespace

TEST_CASE("the window shows what render draws and answers mouse and keys", "[viewer][window]") {
    if (!all_installed()) return;
    const TempFolder folder;
    const Display display(folder);
    const std::string scene = folder.write("ball.toml", ball), err = folder.path / "viewer.log";
    const auto draw = [&](std::vector<std::string> options) {
        return rendered(folder, scene, "200,150", std::move(options));
    };
    Background program({viewer, scene, "--resolution", "200,150"}, folder.path, err);
    const Person person(folder);
    const Image first = draw({});
    CHECK(person.sees(first));

    const auto still = program.ticks();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    CHECK(program.ticks() - still <= 1);

    person.press("s");
    CHECK(person.sees(draw({"--shading", "flat"})));
    person.press("s");
    CHECK(person.sees(draw({"--shading", "gouraud"})));
    person.press("b");
    CHECK(person.sees(draw({"--shading", "gouraud", "--brdf", "blinn-phong"})));
    person.press("b");
    CHECK(person.sees(draw({"--shading", "gouraud", "--brdf", "lambert"})));
    person.press("i");
    CHECK(person.sees(
        draw({"--shading", "gouraud", "--brdf", "lambert", "--interpolation", "edges"})));
    const Image chosen = person.look();

    person.move(60, 60, "mousedown 1");
    person.move(90, 70);
    person.move(110, 75, "mouseup 1");
    CHECK(person.sees_other_than(chosen));
    const Image dragged = person.look();
    person.move(20, 20);  // no button: no orbit
    person.act("click 4");
    CHECK(person.sees_other_than(dragged));
    person.press("Return");
    CHECK(person.sees(chosen));

    person.press("h");
    CHECK(person.sees_other_than(chosen));
    person.press("F12");  // the picture, not the help over it
    CHECK(wait_until([&] { return std::filesystem::exists(folder.path / "ball_1.png"); }));
    CHECK(load_image(folder.path / "ball_1.png").rgb == chosen.rgb);
    person.press("h");
    CHECK(person.sees(chosen));

    person.resize(260, 140);
    CHECK(person.sees(
        rendered(folder, scene, "260,140",
                 {"--shading", "gouraud", "--brdf", "lambert", "--interpolation", "edges"})));

    person.press("q");
    CHECK(wait_until([&] { return program.status().has_value(); }));
    CHECK(program.status() == 0);
    CHECK(read_file(err) == "scanshade-view: saved ball_1.png\n");
}

TEST_CASE("Escape ends the viewer with status 0", "[viewer][window]") {
    if (!all_installed()) return;
    const TempFolder folder;
    const Display display(folder);
    const std::string scene = folder.write("ball.toml", ball), err = folder.path / "viewer.log";
    Background program({viewer, scene}, folder.path, err);
    Person(folder).press("Escape");
    CHECK(wait_until([&] { return program.status().has_value(); }));
    CHECK(program.status() == 0);
    CHECK(read_file(err).empty());
}

TEST_CASE("without a display the viewer says so in one sentence", "[viewer]") {
    const TempFolder folder;
    const std::string scene = folder.write("ball.toml", ball), program = viewer;
    const auto run = [&](const std::string& display) {
        const std::string err = folder.path / "err";
        const int status = ::system(("env -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER -u DISPLAY " +
                                     display + " '" + program + "' '" + scene + "' 2>'" + err + "'")
                                        .c_str());
        return Finished{WEXITSTATUS(status), {}, read_file(err)};
    };
    for (const char* display : {"", "DISPLAY=:9999"}) {
        const Finished finished = run(display);
        CAPTURE(display, finished.err);
        CHECK(finished.status == 3);
        CHECK(finished.err.rfind("scanshade-view: cannot open a window (", 0) == 0);
        CHECK(finished.err.find("`scanshade render` needs n") != std::string::npos);
        CHECK(finished.err.find('\n') == finished.err.size() - 1);
    }
}
