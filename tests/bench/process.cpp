#include "bench/process.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "bench/scenes.hpp"
#include "scanshade/base/error.hpp"
#include "scanshade/base/memory.hpp"
#include "scanshade/base/timer.hpp"

namespace scanshade::bench {
namespace {

enum class Request : int { about, prepare, picture, draw, memory };
enum class Answer : int { good, failed };

/// Plain values, and vectors and strings of them, through a socket.
class Line {
public:
    explicit Line(int descriptor) : descriptor_(descriptor) {}

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void put(const T& value) { put_bytes(&value, sizeof value); }
    template <class Container>
    requires requires(const Container& c) { c.data(); }
    void put(const Container& values) {
        put(values.size());
        put_bytes(values.data(), values.size() * sizeof *values.data());
    }
    template <class T>
    T get() {
        T value{};
        if constexpr (std::is_trivially_copyable_v<T>) {
            get_bytes(&value, sizeof value);
        } else {
            value.resize(get<std::size_t>());
            get_bytes(value.data(), value.size() * sizeof *value.data());
        }
        return value;
    }

private:
    // MSG_NOSIGNAL: the other side may have died.
    void put_bytes(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const char*>(data);
        for (ssize_t n = 0; size > 0; bytes += n, size -= std::size_t(n))
            if ((n = ::send(descriptor_, bytes, size, MSG_NOSIGNAL)) <= 0)
                throw std::runtime_error("the other process is gone");
    }
    void get_bytes(void* data, std::size_t size) {
        auto* bytes = static_cast<char*>(data);
        for (ssize_t n = 0; size > 0; bytes += n, size -= std::size_t(n))
            if ((n = ::recv(descriptor_, bytes, size, 0)) <= 0)
                throw std::runtime_error("the other process is gone");
    }

    int descriptor_;
};

// ---- in the rival's process

/// Frees what is not used and forgets the peak, so that the next one is the cell's own.
std::uint64_t settle_memory() {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;
    return peak_memory_bytes();
}

/// The last core: the first has the system's own work.
void bind_to_one_core() {
    cpu_set_t allowed, one;
    CPU_ZERO(&one);
    if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    for (int core = CPU_SETSIZE - 1; core >= 0; --core)
        if (CPU_ISSET(core, &allowed)) {
            CPU_SET(core, &one);
            ::sched_setaffinity(0, sizeof one, &one);
            return;
        }
}

class Server {
public:
    Server(Line line, const RivalInfo& info, const Group& group)
        : line_(line), info_(info), group_(group) {}

    /// Answers until the line is closed.
    void run() {
        for (;;) {
            const auto request = line_.get<Request>();
            const auto a = line_.get<std::size_t>(), b = line_.get<std::size_t>(),
                       c = line_.get<std::size_t>();
            try {
                if (rival_ == nullptr) start();
                answer(request, a, b, c);
            } catch (const Error& problem) {
                fail(problem.code(), problem.what());
            } catch (const std::exception& problem) {
                fail(Errc::scene, fmt::format("{}: {}", info_.name, problem.what()));
            }
        }
    }

private:
    void start() {
        scene_ = make_scene(group_.scene, group_.mesh_file);
        scene_bytes_ = settle_memory();
        rival_ = info_.make({scene_, group_.cull, group_.threads});
    }

    void answer(Request request, std::size_t a, std::size_t b, std::size_t c) {
        switch (request) {
            case Request::about:
                return reply(rival_->about());
            case Request::prepare:
                return prepare(a);
            case Request::picture:
                return send(rival_->picture(a));
            case Request::draw:
                return draw(a, b, c);
            case Request::memory:
                return reply(Memory{scene_bytes_, peak_memory_bytes() - scene_bytes_});
        }
    }

    void fail(Errc code, const std::string& sentence) {
        line_.put(Answer::failed);
        line_.put(code);
        line_.put(sentence);
    }

    template <class T>
    void reply(const T& value) {
        line_.put(Answer::good);
        line_.put(value);
    }

    void prepare(std::size_t cell) {
        settle_memory();
        const std::vector<std::string> ways = rival_->prepare(group_.cells[cell]);
        reply(ways.size());
        for (const std::string& way : ways) line_.put(way);
    }

    void send(const Picture& picture) {
        reply(picture.rgba);
        line_.put(picture.id);
        line_.put(picture.copy_out_ms);
    }

    void draw(std::size_t way, std::size_t untimed, std::size_t timed) {
        for (std::size_t i = 0; i < untimed; ++i) rival_->draw(way);
        std::vector<double> ms(timed);
        for (double& frame : ms) {
            const Timer timer;
            rival_->draw(way);
            frame = timer.ms();
        }
        reply(ms);
    }

    Line line_;
    const RivalInfo& info_;
    const Group& group_;
    Scene scene_;
    std::uint64_t scene_bytes_ = 0;
    std::unique_ptr<Rival> rival_;
};

[[noreturn]] void serve(int line, const RivalInfo& info, const Group& group) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Stock glibc gives large blocks back after every frame, and gets them zeroed for the next.
    ::mallopt(M_MMAP_THRESHOLD, 1 << 25);
    ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
    if (group.threads == 1) bind_to_one_core();
    try {
        Server(Line(line), info, group).run();
    } catch (const std::exception&) {
        // The line is closed: the work is done.
    }
    std::_Exit(0);
}

// ---- in ours

void request(Line& line, const char* name, Request what, std::size_t a = 0, std::size_t b = 0,
             std::size_t c = 0) {
    try {
        line.put(what);
        for (const std::size_t argument : {a, b, c}) line.put(argument);
        if (line.get<Answer>() == Answer::good) return;
    } catch (const std::runtime_error&) {
        throw Error(Errc::scene, fmt::format("the process of {} has died", name));
    }
    const auto code = line.get<Errc>();
    throw Error(code, line.get<std::string>());
}

}  // namespace

RivalProcess::RivalProcess(const RivalInfo& info, const Group& group) : info_(info) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw Error(Errc::scene, "the system gives no socket to talk to a rival's process");
    child_ = ::fork();
    if (child_ < 0) throw Error(Errc::scene, "the system starts no process for a rival");
    if (child_ == 0) {
        ::close(ends[0]);
        serve(ends[1], info, group);
    }
    ::close(ends[1]);
    line_ = ends[0];
}

RivalProcess::~RivalProcess() {
    // A later rival's process holds a copy of this line, so closing it is not enough.
    ::shutdown(line_, SHUT_RDWR);
    ::close(line_);
    ::waitpid(child_, nullptr, 0);
}

std::string RivalProcess::about() {
    Line line(line_);
    request(line, name(), Request::about);
    return line.get<std::string>();
}

std::vector<std::string> RivalProcess::prepare(std::size_t cell) {
    Line line(line_);
    request(line, name(), Request::prepare, cell);
    std::vector<std::string> ways(line.get<std::size_t>());
    for (std::string& way : ways) way = line.get<std::string>();
    return ways;
}

Picture RivalProcess::picture(std::size_t way) {
    Line line(line_);
    request(line, name(), Request::picture, way);
    Picture picture;
    picture.rgba = line.get<std::vector<std::uint32_t>>();
    picture.id = line.get<std::vector<std::uint32_t>>();
    picture.copy_out_ms = line.get<double>();
    return picture;
}

std::vector<double> RivalProcess::draw(std::size_t way, int untimed, int timed) {
    Line line(line_);
    request(line, name(), Request::draw, way, std::size_t(untimed), std::size_t(timed));
    return line.get<std::vector<double>>();
}

Memory RivalProcess::memory() {
    Line line(line_);
    request(line, name(), Request::memory);
    return line.get<Memory>();
}

}  // namespace scanshade::bench
